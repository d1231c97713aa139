#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Σ area × unit normal (L²) over the triangles at v that touch the air, each normal pointing into the air; zero where
/// there are none.
Vec3 air_side_area_vector(const SurfaceMesh& mesh, Vertex v);

/// The unit vector along it: the area-weighted normal of the air's side at v; zero where v has none, or where the
/// triangles cancel each other (a film with air on both sides cannot be: its labels would be equal).
Vec3 air_side_normal(const SurfaceMesh& mesh, Vertex v);

/// The same with vertices at `positions` (L, one a vertex slot).
Vec3 air_side_normal(const SurfaceMesh& mesh, Vertex v, std::span<const Vec3> positions);

/// Whether a triangle at v touches the air.
bool touches_air(const SurfaceMesh& mesh, Vertex v);

/// Area of the triangles that touch the air (L²), and of those that separate two other regions.
struct AreaBySide {
  double air_side = 0, shared = 0;
};
AreaBySide area_by_side(const SurfaceMesh& mesh);

}  // namespace lostopos
