#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A closed solid under construction: points and triangles whose right-hand normals point outwards.
struct IndexedSurface {
  std::vector<lostopos::Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Each triangle into four at its edges' midpoints, `times` over.
IndexedSurface subdivided(IndexedSurface surface, long times);

/// The solid as region 1 in the air.
lostopos::SurfaceMesh as_bubble(const IndexedSurface& surface);

}  // namespace foamsim
