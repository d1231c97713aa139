#include "FoamSim/studies/stability/shapes/border_edits.h"

#include <algorithm>
#include <random>
#include <set>

#include "Base/error.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

Vec3 middle(const SurfaceMesh& mesh, Edge e) {
  const auto [a, b] = mesh.vertices(e);
  return (mesh.position(a) + mesh.position(b)) / 2;
}

std::vector<Edge> junction_edges(const SurfaceMesh& mesh) {
  std::vector<Edge> edges;
  for (Edge e : mesh.edges())
    if (mesh.is_junction(e)) edges.push_back(e);
  return edges;
}

// a, the points between, b.
std::vector<Vertex> divided(SurfaceMesh& mesh, Vertex a, Vertex b, long parts) {
  std::vector<Vertex> chain{a};
  const Vec3 from = mesh.position(a), to = mesh.position(b);
  for (long i = 1; i < parts; ++i)
    chain.push_back(mesh.add_vertex(from + (to - from) * (static_cast<double>(i) / static_cast<double>(parts))));
  chain.push_back(b);
  return chain;
}

void replace_by_fan(SurfaceMesh& mesh, Triangle t, Edge e, std::vector<Vertex> chain) {
  const Vertex pole = mesh.opposite_vertex(t, e);
  const lostopos::Labels labels = mesh.labels(t);
  if (!mesh.runs_along(t, e)) std::ranges::reverse(chain);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) mesh.add_triangle(chain[i], chain[i + 1], pole, labels);
  mesh.remove_triangle(t);
}

}  // namespace

SurfaceMesh with_divided_borders(const SurfaceMesh& mesh, long parts) {
  if (parts < 1) throw base::InputError("a border has to be divided into one or more parts");
  SurfaceMesh result = mesh.clone();
  if (parts == 1) return result;
  for (Edge e : junction_edges(mesh)) {
    const auto triangles = std::vector<Triangle>(mesh.triangles(e).begin(), mesh.triangles(e).end());
    const auto [a, b] = mesh.vertices(e);
    const auto chain = divided(result, a, b, parts);
    for (Triangle t : triangles) replace_by_fan(result, t, e, chain);
  }
  result.compact();
  return result;
}

std::size_t press_slivers(SurfaceMesh& mesh, double height) {
  constexpr std::size_t most_triangles = 8;
  std::set<Vertex> moved;
  const auto edges = junction_edges(mesh);
  for (std::size_t i = 0; i < edges.size(); i += 2)
    for (Triangle t : mesh.triangles(edges[i])) {
      const Vertex v = mesh.opposite_vertex(t, edges[i]);
      if (mesh.is_junction(v) || mesh.triangles(v).size() > most_triangles || !moved.insert(v).second) continue;
      const Vec3 foot = middle(mesh, edges[i]);
      mesh.set_position(v, foot + height * (mesh.position(v) - foot).normalized());
    }
  return moved.size();
}

void add_noise(SurfaceMesh& mesh, double amplitude, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // 53 bits of each number, so that every implementation of the library draws the same.
  auto draw = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
  for (Vertex v : mesh.vertices()) {
    const double x = draw(), y = draw(), z = draw();
    mesh.set_position(v, mesh.position(v) + amplitude * Vec3(x, y, z));
  }
}

void transform(SurfaceMesh& mesh, double scale, const Vec3& offset) {
  for (Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) * scale + offset);
}

double most_stretched_at_borders(const SurfaceMesh& mesh) {
  double largest = 0;
  for (Edge e : junction_edges(mesh))
    for (Triangle t : mesh.triangles(e)) {
      double longest = 0;
      for (Edge side : mesh.edges(t)) longest = std::max(longest, lostopos::length(mesh, side));
      largest = std::max(largest, longest * longest / (2 * lostopos::area(mesh, t)));
    }
  return largest;
}

}  // namespace foamsim
