#pragma once

#include <span>

#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// A vertex with everything around it that a curvature scheme or an area strategy may look at.
struct VertexStar {
  const lostopos::SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;
  lostopos::Vertex vertex;
  std::span<const lostopos::Region> regions;  ///< the regions at the vertex, ascending
  bool junction;                              ///< some edge at the vertex has more than two triangles
};

}  // namespace foamsim
