#pragma once

#include <functional>
#include <vector>

#include "LosTopos/collision/safe_move.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos::test {

/// Adds a copy of `part`, each vertex mapped, with region 1 renamed `inside`. Returns the new vertices by old index.
std::vector<Vertex> add_part(SurfaceMesh& mesh, const SurfaceMesh& part, Region inside,
                             const std::function<Vec3(const Vec3&)>& map);

/// A flat square sheet of n by n squares, two triangles each, with its corner at `corner` and sides along u and v,
/// between regions `below` and `above` (the side that u x v points to). Returns its vertices, row by row.
std::vector<Vertex> add_sheet(SurfaceMesh& mesh, long n, const Vec3& corner, const Vec3& u, const Vec3& v,
                              Labels labels);

std::vector<Vec3> positions_of(const SurfaceMesh& mesh);

/// Moves, adds to `sum`, and expects: a clean audit (intersections are tested exactly), held vertices at the asked
/// fraction of their way, to the bit when it is 1. False when something is wrong, so that a loop can stop.
bool move_and_check(SurfaceMesh& mesh, const std::vector<Vec3>& predicted, const std::vector<Hold>& held,
                    const MoveOptions& options, MoveStatistics& sum, bool closed = true);

/// For the test's log.
void print(const char* what, const MoveStatistics& sum);

}  // namespace lostopos::test
