#include "FoamSim/sheet/pressure/curvature.h"

#include <algorithm>

#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

void EdgeAngleCurvature::evaluate(const VertexStar& star, std::span<double> curvature) const {
  boost::container::small_vector<double, 8> area(star.regions.size());
  area_->evaluate(star, {area.data(), area.size()});
  std::ranges::fill(curvature, 0.0);
  for (Edge e : star.mesh.edges(star.vertex))
    for (const RegionEdgeCurvature& at_edge : star.geometry.curvatures(e)) {
      const auto place = std::ranges::lower_bound(star.regions, at_edge.region) - star.regions.begin();
      curvature[place] += at_edge.kappa;
    }
  for (std::size_t i = 0; i < curvature.size(); ++i) curvature[i] = area[i] > 0 ? curvature[i] / (2 * area[i]) : 0.0;
}

void evaluate_curvature(const SurfaceMesh& mesh, const SurfaceGeometry& geometry, const EdgeAngleCurvature& curvature,
                        std::vector<double>& values) {
  values.resize(geometry.entries());
  lostopos::for_each_vertex(
      mesh,
      [&](Vertex v) {
        const VertexStar star{mesh, geometry, v, geometry.regions(v), mesh.is_junction(v)};
        curvature.evaluate(star, {values.data() + geometry.first_entry(v), star.regions.size()});
      },
      128);
}

std::span<const double> CurvatureField::at(const SurfaceGeometry& geometry, Vertex v) const {
  return {values_.data() + geometry.first_entry(v), geometry.regions(v).size()};
}

double CurvatureField::get(const SurfaceGeometry& geometry, Vertex v, Region r) const {
  const auto regions = geometry.regions(v);
  const auto it = std::ranges::lower_bound(regions, r);
  return it != regions.end() && *it == r ? at(geometry, v)[it - regions.begin()] : 0.0;
}

}  // namespace foamsim
