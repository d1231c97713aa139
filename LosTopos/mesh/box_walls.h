#pragma once

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// The walls of a box, L.
struct BoxWalls {
  Vec3 low = Vec3::Zero(), high = Vec3::Ones();
};

/// Files have positions on walls to this, over the box's side.
inline constexpr double wall_tolerance = 1e-6;

/// The coordinates in which a point is at a wall, to the tolerance.
Hold walls_at(const BoxWalls& walls, const Vec3& x);
/// Whether there is a wall that both points are at, to the tolerance.
bool share_a_wall(const BoxWalls& walls, const Vec3& a, const Vec3& b);
/// The sum of the outward normals of the walls that both points are at; zero where there is none.
Vec3 outward_of_shared_walls(const BoxWalls& walls, const Vec3& a, const Vec3& b);

/// Lets the vertices on the walls of the box from `low` to `high` slide: each holds the coordinates in which it is at
/// either to the bit, in addition to what it holds already.
void hold_in_box_walls(const SurfaceMesh& mesh, VertexAttribute<Hold>& held, const Vec3& low, const Vec3& high);

/// Where a point that is at walls to the tolerance, or beyond them, is on them to the bit; every other stays.
Vec3 put_on_walls(const BoxWalls& walls, const Vec3& x);

/// Whether the surface ends, and every edge at which it ends lies in a wall.
bool ends_at_walls(const SurfaceMesh& mesh, const BoxWalls& walls);

/// Of a surface that ends at walls: removes the triangles with all three corners on one wall to the bit, behind which
/// there is nothing that they could part, and vertices that have no other. Returns their number.
std::size_t remove_triangles_in_walls(SurfaceMesh& mesh, const BoxWalls& walls);

}  // namespace lostopos
