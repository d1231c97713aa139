#include "LosTopos/mesh/box_walls.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lostopos {
namespace {

// Of coordinate i: −1 at the low wall, 1 at the high one, 0 at neither.
int wall_of(const BoxWalls& walls, const Vec3& x, int i) {
  const double tolerance = wall_tolerance * (walls.high[i] - walls.low[i]);
  if (std::abs(x[i] - walls.low[i]) <= tolerance) return -1;
  return std::abs(x[i] - walls.high[i]) <= tolerance ? 1 : 0;
}

bool lies_in_a_wall(const SurfaceMesh& mesh, const BoxWalls& walls, Triangle t) {
  const auto all_at = [&](int i, double wall) {
    return std::ranges::all_of(mesh.vertices(t), [&](Vertex v) { return mesh.position(v)[i] == wall; });
  };
  for (int i = 0; i < 3; ++i)
    if (all_at(i, walls.low[i]) || all_at(i, walls.high[i])) return true;
  return false;
}

}  // namespace

Hold walls_at(const BoxWalls& walls, const Vec3& x) {
  Hold hold = Hold::none;
  for (int i = 0; i < 3; ++i)
    if (wall_of(walls, x, i) != 0) hold |= hold_of_coordinate(i);
  return hold;
}

bool share_a_wall(const BoxWalls& walls, const Vec3& a, const Vec3& b) {
  return !outward_of_shared_walls(walls, a, b).isZero(0);
}

Vec3 outward_of_shared_walls(const BoxWalls& walls, const Vec3& a, const Vec3& b) {
  Vec3 outward = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (const int wall = wall_of(walls, a, i); wall_of(walls, b, i) == wall) outward[i] = wall;
  return outward;
}

void hold_in_box_walls(const SurfaceMesh& mesh, VertexAttribute<Hold>& held, const Vec3& low, const Vec3& high) {
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    for (int i = 0; i < 3; ++i)
      if (x[i] == low[i] || x[i] == high[i]) held[v] |= hold_of_coordinate(i);
  }
}

Vec3 put_on_walls(const BoxWalls& walls, const Vec3& position) {
  Vec3 x = position.cwiseMax(walls.low).cwiseMin(walls.high);
  for (int i = 0; i < 3; ++i)
    if (const int wall = wall_of(walls, x, i); wall != 0) x[i] = wall < 0 ? walls.low[i] : walls.high[i];
  return x;
}

bool ends_at_walls(const SurfaceMesh& mesh, const BoxWalls& walls) {
  bool ends = false;
  for (Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 1) continue;
    const auto& [a, b] = mesh.vertices(e);
    if (!share_a_wall(walls, mesh.position(a), mesh.position(b))) return false;
    ends = true;
  }
  return ends;
}

std::size_t remove_triangles_in_walls(SurfaceMesh& mesh, const BoxWalls& walls) {
  std::vector<Triangle> flat;
  for (Triangle t : mesh.triangles())
    if (lies_in_a_wall(mesh, walls, t)) flat.push_back(t);
  for (Triangle t : flat) {
    const auto corners = mesh.vertices(t);
    mesh.remove_triangle(t);
    for (Vertex v : corners)
      if (mesh.triangles(v).empty()) mesh.remove_vertex(v);
  }
  return flat.size();
}

}  // namespace lostopos
