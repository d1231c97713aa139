#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

struct Sphere {
  Vec3 centre;    ///< L
  double radius;  ///< L
};

enum class SphereLayout {
  grid,    ///< centres on a unit grid, each coordinate jittered by up to ±0.08; radii 0.34 to 0.40
  random,  ///< centres anywhere in a box with one unit of volume a sphere; radii 0.15 to 0.45
};
/// "grid" or "random"; throws InputError that says so for any other word.
SphereLayout sphere_layout_by_name(std::string_view name);

struct SphereLayoutOptions {
  long spheres = 8;  ///< 1 to 1,000,000
  SphereLayout layout = SphereLayout::grid;
  std::uint64_t seed = 1;
};

/// Spheres that do not touch: at least 0.02 lies between any two. The first of a grid sits near (0, 0, 0), the others
/// follow along x, then y, then z in the smallest cube that has room; a random box that has no room for a sphere after
/// many attempts grows. The same options give the same bits. Throws InputError for options out of range.
std::vector<Sphere> sphere_layout(const SphereLayoutOptions& options);

/// Every sphere as an icosphere of 320 triangles; regions 1, 2, … in the order given, or all of them region 1.
SurfaceMesh sphere_meshes(const std::vector<Sphere>& spheres, bool one_region = false);

}  // namespace lostopos
