#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A closed solid under construction: points and triangles whose right-hand normals point outwards.
struct IndexedSurface {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Each triangle into four at its edges' midpoints, `times` over.
IndexedSurface subdivided(IndexedSurface surface, long times);

/// The solid as region 1 in the air.
SurfaceMesh as_bubble(const IndexedSurface& surface);

}  // namespace lostopos
