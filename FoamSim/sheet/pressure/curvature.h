#pragma once

#include <memory>
#include <span>
#include <vector>

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"
#include "FoamSim/sheet/pressure/vertex_star.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// A discretisation of mean curvature: maps a vertex's star to one value per region there.
class CurvatureScheme {
 public:
  CurvatureScheme() = default;
  CurvatureScheme(const CurvatureScheme&) = delete;
  CurvatureScheme& operator=(const CurvatureScheme&) = delete;
  virtual ~CurvatureScheme() = default;
  /// Writes H_v^r (1/L), the sum of the principal curvatures, positive where r is convex, for each of star.regions.
  virtual void evaluate(const VertexStar& star, std::span<double> curvature) const = 0;
};

/// Edge angle over area: H_v^r = (1 / (2 A_v^r)) Σ_{e at v} κ_e^r with the area A from a strategy (Da et al. 2015;
/// Fei et al. 2019; Cohen-Steiner and Morvan 2003). On a ball of radius R it tends to 2/R.
class EdgeAngleCurvature final : public CurvatureScheme {
 public:
  explicit EdgeAngleCurvature(std::unique_ptr<VertexArea> area) : area_(std::move(area)) {}
  void evaluate(const VertexStar& star, std::span<double> curvature) const override;

 private:
  std::unique_ptr<VertexArea> area_;
};

/// H for every (vertex, region), stored in the order of SurfaceGeometry's entries.
class CurvatureField {
 public:
  /// Evaluates the scheme at every vertex in parallel; results do not depend on the number of threads.
  void update(const lostopos::SurfaceMesh& mesh, const SurfaceGeometry& geometry, const CurvatureScheme& scheme);
  /// H_v^r for geometry.regions(v), in that order.
  std::span<const double> at(const SurfaceGeometry& geometry, lostopos::Vertex v) const;
  /// H_v^r; 0 where r is not at v.
  double get(const SurfaceGeometry& geometry, lostopos::Vertex v, lostopos::Region r) const;

 private:
  std::vector<double> values_;
};

}  // namespace foamsim
