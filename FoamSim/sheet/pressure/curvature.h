#pragma once

#include <memory>
#include <span>
#include <vector>

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"
#include "FoamSim/sheet/pressure/vertex_star.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// Edge angle over area: H_v^r = (1 / (2 A_v^r)) Σ_{e at v} κ_e^r with the area A from a strategy (Da et al. 2015;
/// Fei et al. 2019; Cohen-Steiner and Morvan 2003). On a ball of radius R it tends to 2/R.
class EdgeAngleCurvature {
 public:
  explicit EdgeAngleCurvature(std::unique_ptr<VertexArea> area) : area_(std::move(area)) {}
  /// Writes H_v^r (1/L), the sum of the principal curvatures, positive where r is convex, for each of star.regions.
  void evaluate(const VertexStar& star, std::span<double> curvature) const;

 private:
  std::unique_ptr<VertexArea> area_;
};

/// H (1/L) for every (vertex, region) into `values`, in the order of SurfaceGeometry's entries; in parallel, and the
/// same bits for any number of threads.
void evaluate_curvature(const lostopos::SurfaceMesh& mesh, const SurfaceGeometry& geometry,
                        const EdgeAngleCurvature& curvature, std::vector<double>& values);

/// H for every (vertex, region), stored in the order of SurfaceGeometry's entries.
class CurvatureField {
 public:
  void update(const lostopos::SurfaceMesh& mesh, const SurfaceGeometry& geometry, const EdgeAngleCurvature& curvature) {
    evaluate_curvature(mesh, geometry, curvature, values_);
  }
  /// H_v^r for geometry.regions(v), in that order.
  std::span<const double> at(const SurfaceGeometry& geometry, lostopos::Vertex v) const;
  /// H_v^r; 0 where r is not at v.
  double get(const SurfaceGeometry& geometry, lostopos::Vertex v, lostopos::Region r) const;

 private:
  std::vector<double> values_;
};

}  // namespace foamsim
