#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A triangle at some place, with what certifies that others are away from it.
struct PlacedTriangle {
  std::array<Vertex, 3> names;
  std::array<Vec3, 3> x;       ///< L
  std::array<Vec3, 3> inward;  ///< in its plane, from the side opposite to corner i towards it; any length
  Vec3 normal;                 ///< any length
};

/// t with its corners at `places` (L, indexed by vertex handle).
PlacedTriangle placed_triangle(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> places);

/// Whether a plane of t's has all of u's corners (at `places`) at least `distance` (L) beyond it: then nothing of them
/// is near. To be asked first.
bool is_beyond(const PlacedTriangle& t, const SurfaceMesh& mesh, Triangle u, std::span<const Vec3> places,
               double distance);

/// Whether a vertex of one and the other triangle, or an edge of each, that have no vertex in common are nearer to each
/// other than `distance` (L), up to rounding. Most pairs are told apart by planes that lie between them; triangles
/// that have a vertex or an edge in common by planes between their other parts.
bool have_near_elements(const PlacedTriangle& t, const PlacedTriangle& u, double distance);

}  // namespace lostopos
