#include "LosTopos/topology/region_surface.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "Base/lists/disjoint_sets.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/topology/sectors.h"

namespace lostopos {
namespace {

std::size_t place_of(const std::array<Edge, 3>& edges, Edge e) {
  return static_cast<std::size_t>(std::ranges::find(edges, e) - edges.begin());
}

std::size_t place_of(const std::array<Vertex, 3>& vertices, Vertex v) {
  return static_cast<std::size_t>(std::ranges::find(vertices, v) - vertices.begin());
}

}  // namespace

RegionSurface::RegionSurface(const SurfaceMesh& mesh, Region region) {
  for (Triangle t : mesh.triangles()) {
    if (!mesh.labels(t).has(region)) continue;
    sides_.push_back(t);
    faces_forward_.push_back(mesh.labels(t).q == region);
  }
  across_.assign(3 * sides_.size(), none);
  join_sides(mesh, region);
  number_vertices(mesh);
}

std::array<std::array<std::size_t, 2>, 2> RegionSurface::joined_corners(const SurfaceMesh& mesh,
                                                                        std::size_t half_edge) const {
  const std::size_t s = half_edge / 3, t = across_[half_edge] / 3;
  std::array<std::array<std::size_t, 2>, 2> pairs;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t k = (half_edge + 1 + i) % 3;
    pairs[i] = {3 * s + k, 3 * t + place_of(mesh.vertices(sides_[t]), mesh.vertices(sides_[s])[k])};
  }
  return pairs;
}

void RegionSurface::join_sides(const SurfaceMesh& mesh, Region region) {
  std::vector<std::uint32_t> side_of(mesh.triangle_slots(), none);
  for (std::size_t s = 0; s < sides_.size(); ++s) side_of[sides_[s].index()] = static_cast<std::uint32_t>(s);
  std::vector<std::uint32_t> here;
  for (Edge e : mesh.edges()) {
    here.clear();
    for (Triangle t : mesh.triangles(e))
      if (side_of[t.index()] != none) here.push_back(side_of[t.index()]);
    if (here.size() == 2) {
      join(mesh, e, here[0], here[1]);
    } else if (here.size() > 2) {
      const FilmsAtEdge films = films_around(mesh, mesh.vertices(e)[0], e);
      for (std::size_t i = 0; i < films.size(); ++i) {
        const FilmAtEdge &film = films[i], &next = films[(i + 1) % films.size()];
        if (film.after == region && next.before == region)
          join(mesh, e, side_of[film.triangle.index()], side_of[next.triangle.index()]);
      }
    }
  }
}

void RegionSurface::join(const SurfaceMesh& mesh, Edge e, std::uint32_t s, std::uint32_t t) {
  const auto half_edge = [&](std::uint32_t side) {
    return static_cast<std::uint32_t>(3 * side + place_of(mesh.edges(sides_[side]), e));
  };
  across_[half_edge(s)] = half_edge(t);
  across_[half_edge(t)] = half_edge(s);
}

void RegionSurface::number_vertices(const SurfaceMesh& mesh) {
  base::DisjointSets corners(3 * sides_.size());
  for (std::size_t h = 0; h < across_.size(); ++h) {
    if (across_[h] == none || across_[h] < h) continue;
    for (const auto& [a, b] : joined_corners(mesh, h)) corners.unite(a, b);
  }
  vertex_.resize(3 * sides_.size());
  for (std::size_t c = 0; c < vertex_.size(); ++c) {
    const std::size_t first = corners.find(c);
    vertex_[c] = first == c ? static_cast<std::uint32_t>(vertex_count_++) : vertex_[first];
  }
}

std::vector<RegionSurface::Piece> RegionSurface::pieces(const SurfaceMesh& mesh) const {
  std::vector<Piece> found;
  std::vector<char> is_found(sides_.size(), 0), is_counted(vertex_count_, 0);
  for (std::size_t first = 0; first < sides_.size(); ++first) {
    if (is_found[first] != 0) continue;
    Piece piece{.sides = {static_cast<std::uint32_t>(first)}};
    is_found[first] = 1;
    for (std::size_t i = 0; i < piece.sides.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t twin = across_[3 * std::size_t{piece.sides[i]} + k];
        if (twin == none || is_found[twin / 3] != 0) continue;
        is_found[twin / 3] = 1;
        piece.sides.push_back(twin / 3);
      }
    }
    measure(mesh, piece, is_counted);
    found.push_back(std::move(piece));
  }
  return found;
}

void RegionSurface::measure(const SurfaceMesh& mesh, Piece& piece, std::vector<char>& is_counted) const {
  const Vec3 origin = barycentre(mesh, sides_[piece.sides.front()]);
  double edges = 0, vertices = 0;
  for (std::uint32_t s : piece.sides) {
    const auto [a, b, c] = corners(mesh, sides_[s]);
    const double volume = (a - origin).dot((b - origin).cross(Vec3(c - origin))) / 6;
    piece.volume += faces_forward_[s] != 0 ? -volume : volume;
    for (std::size_t corner = 3 * std::size_t{s}; corner < 3 * std::size_t{s} + 3; ++corner) {
      const bool ends_here = across_[corner] == none;
      edges += ends_here ? 1 : 0.5;
      if (ends_here) piece.closed = false;
      char& counted = is_counted[vertex_[corner]];
      if (counted == 0) ++vertices;
      counted = 1;
    }
  }
  piece.genus = 1 - 0.5 * (vertices - edges + static_cast<double>(piece.sides.size()));
}

}  // namespace lostopos
