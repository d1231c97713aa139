#pragma once

#include <span>

#include "FoamSim/sheet/pressure/vertex_star.h"

namespace foamsim {

/// The area that normalises curvature at a vertex: the one thing in which the report's three methods differ
/// (Fei et al. 2019). Off the junctions all strategies agree on a third of the area of the vertex's triangles.
class VertexArea {
 public:
  VertexArea() = default;
  VertexArea(const VertexArea&) = delete;
  VertexArea& operator=(const VertexArea&) = delete;
  virtual ~VertexArea() = default;
  /// Writes A_v^r (L²) for each of star.regions.
  virtual void evaluate(const VertexStar& star, std::span<double> area) const = 0;
};

/// One third of the area of the triangles at the vertex that bound each region.
void area_of_own_triangles(const VertexStar& star, std::span<double> area);

}  // namespace foamsim
