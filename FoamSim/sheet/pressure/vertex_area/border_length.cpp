#include "FoamSim/sheet/pressure/vertex_area/border_length.h"

#include <algorithm>
#include <numeric>

#include "FoamSim/sheet/pressure/vertex_area/averaged.h"

namespace foamsim {
namespace {

bool bounds(const lostopos::SurfaceMesh& mesh, lostopos::Edge e, lostopos::Region r) {
  return std::ranges::any_of(mesh.triangles(e), [&](lostopos::Triangle t) { return mesh.labels(t).has(r); });
}

double border_length(const VertexStar& star, lostopos::Region r) {
  double sum = 0;
  for (lostopos::Edge e : star.mesh.edges(star.vertex))
    if (star.mesh.is_junction(e) && bounds(star.mesh, e, r)) sum += star.geometry.length(e);
  return sum;
}

}  // namespace

void BorderLengthArea::evaluate(const VertexStar& star, std::span<double> area) const {
  AveragedArea().evaluate(star, area);
  // With three regions every border bounds all of them.
  if (!star.junction || star.regions.size() < 4) return;
  const double averaged = area[0];
  std::ranges::transform(star.regions, area.begin(), [&](lostopos::Region r) { return border_length(star, r); });
  // A region without a border touches the others at the vertex only, as before a T1: there is nothing to share by.
  const double least = std::ranges::min(area),
               mean = std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(area.size());
  for (double& a : area) a = least > 0 ? averaged * a / mean : averaged;
}

}  // namespace foamsim
