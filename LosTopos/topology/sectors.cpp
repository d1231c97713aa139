#include "LosTopos/topology/sectors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "Base/lists/disjoint_sets.h"
#include "Base/lists/erase_repeated.h"

namespace lostopos {
namespace {

using Regions = boost::container::small_vector<Region, 8>;
using RegionPairs = boost::container::small_vector<std::pair<Region, Region>, 8>;

template <class List>
std::size_t count_distinct(List& list) {
  base::sort_unique(list);
  return list.size();
}

std::size_t place_of(std::span<const Triangle> triangles, Triangle t) {
  return static_cast<std::size_t>(std::ranges::find(triangles, t) - triangles.begin());
}

// Whether the films at v are connected through edges at v.
bool is_one_part(const SurfaceMesh& mesh, Vertex v) {
  const auto triangles = mesh.triangles(v);
  base::DisjointSets parts(triangles.size());
  std::size_t count = triangles.size();
  for (Edge e : mesh.edges(v)) {
    const auto around = mesh.triangles(e);
    for (std::size_t i = 1; i < around.size(); ++i) {
      const std::size_t a = parts.find(place_of(triangles, around[0])), b = parts.find(place_of(triangles, around[i]));
      if (a == b) continue;
      parts.unite(a, b);
      --count;
    }
  }
  return count <= 1;
}

std::vector<SurfaceMesh::TriangleList> parts_at(const SurfaceMesh& mesh, Vertex v) {
  const auto triangles = mesh.triangles(v);
  base::DisjointSets sets(triangles.size());
  for (Edge e : mesh.edges(v))
    for (Triangle t : mesh.triangles(e)) sets.unite(place_of(triangles, mesh.triangles(e)[0]), place_of(triangles, t));
  std::vector<SurfaceMesh::TriangleList> parts;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t root = sets.find(i);
    const auto known = std::ranges::find(roots, root);
    const auto at = static_cast<std::size_t>(known - roots.begin());
    if (known == roots.end()) {
      roots.push_back(root);
      parts.emplace_back();
    }
    parts[at].push_back(triangles[i]);
  }
  return parts;
}

}  // namespace

bool is_complete(const SurfaceMesh& mesh, Vertex v) {
  const auto triangles = mesh.triangles(v);
  const auto edges = mesh.edges(v);
  Regions regions;
  RegionPairs pairs;
  for (Edge e : edges)
    if (mesh.triangles(e).size() == 1) return true;
  for (Triangle t : triangles) {
    const auto [p, q] = mesh.labels(t);
    regions.push_back(p);
    regions.push_back(q);
    pairs.push_back(std::minmax(p, q));
  }
  if (!is_one_part(mesh, v)) return false;
  const std::size_t sectors = triangles.size() + 2 - edges.size();
  const std::size_t region_count = count_distinct(regions), pair_count = count_distinct(pairs);
  return sectors == region_count && pair_count == region_count * (region_count - 1) / 2;
}

FilmsAtEdge films_around(const SurfaceMesh& mesh, Vertex v, Edge e) {
  const Vec3& x = mesh.position(v);
  const Vec3 axis = (mesh.position(mesh.other_vertex(e, v)) - x).normalized();
  const Vec3 u = axis.unitOrthogonal(), w = axis.cross(u);
  const bool starts_at_v = mesh.vertices(e)[0] == v;
  FilmsAtEdge films;
  for (Triangle t : mesh.triangles(e)) {
    const Vec3 arm = mesh.position(mesh.opposite_vertex(t, e)) - x;
    const Labels labels = mesh.runs_along(t, e) == starts_at_v ? mesh.labels(t) : mesh.labels(t).flipped();
    films.push_back({std::atan2(arm.dot(w), arm.dot(u)), t, labels.p, labels.q});
  }
  std::ranges::sort(films, {}, &FilmAtEdge::angle);
  return films;
}

Neighbourhood neighbourhood(const SurfaceMesh& mesh, Vertex v) {
  Neighbourhood result;
  result.parts = parts_at(mesh, v);
  if (result.parts.size() > 1) return result;
  // Every triangle has two sides at v; sides that face each other across an edge belong to one sector.
  const auto triangles = mesh.triangles(v);
  auto side = [&](Triangle t, Region r) { return 2 * place_of(triangles, t) + (mesh.labels(t).p == r ? 0 : 1); };
  base::DisjointSets sets(2 * triangles.size());
  for (Edge e : mesh.edges(v)) {
    const FilmsAtEdge films = films_around(mesh, v, e);
    if (films.size() < 2) continue;
    for (std::size_t i = 0; i < films.size(); ++i) {
      const FilmAtEdge &film = films[i], &next = films[(i + 1) % films.size()];
      if (film.after != next.before) {
        result.consistent = false;
        return result;
      }
      sets.unite(side(film.triangle, film.after), side(next.triangle, next.before));
    }
  }
  std::vector<std::size_t> roots;
  for (std::size_t s = 0; s < 2 * triangles.size(); ++s) {
    const std::size_t root = sets.find(s);
    const auto known = std::ranges::find(roots, root);
    const auto at = static_cast<std::size_t>(known - roots.begin());
    const Triangle t = triangles[s / 2];
    if (known == roots.end()) {
      roots.push_back(root);
      result.sectors.push_back({s % 2 == 0 ? mesh.labels(t).p : mesh.labels(t).q, {}});
    }
    result.sectors[at].triangles.push_back(t);
  }
  return result;
}

}  // namespace lostopos
