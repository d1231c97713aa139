#include "LosTopos/mesh/surface_mesh.h"

#include <algorithm>
#include <string>

#include "LosTopos/error.h"

namespace lostopos {
namespace {

template <class List, class H>
void erase_keeping_order(List& list, H element) {
  list.erase(std::find(list.begin(), list.end(), element));
}

// Arrays that are indexed by slot grow by half, not by doubling: a large mesh carries less slack.
template <class T>
void grow_to(std::vector<T>& values, std::size_t slots) {
  if (slots > values.capacity()) values.reserve(std::max(slots, values.capacity() + values.capacity() / 2));
  values.resize(slots);
}

}  // namespace

SurfaceMesh::SurfaceMesh()
    : vertex_attributes_(std::make_shared<AttributeRegistry>()),
      edge_attributes_(std::make_shared<AttributeRegistry>()),
      triangle_attributes_(std::make_shared<AttributeRegistry>()) {}

void SurfaceMesh::reserve(std::size_t vertices, std::size_t triangles) {
  const std::size_t edges = triangles + triangles / 2 + triangles / 32;
  vertices_.reserve(vertices);
  positions_.reserve(vertices);
  vertex_edges_.reserve(vertices);
  vertex_triangles_.reserve(vertices);
  edges_.reserve(edges);
  edge_vertices_.reserve(edges);
  edge_triangles_.reserve(edges);
  triangles_.reserve(triangles);
  triangle_vertices_.reserve(triangles);
  triangle_edges_.reserve(triangles);
  labels_.reserve(triangles);
}

Vertex SurfaceMesh::add_vertex(const Vec3& position) {
  const std::uint32_t slot = vertices_.take();
  if (vertices_.slots() > positions_.size()) {
    grow_to(positions_, vertices_.slots());
    grow_to(vertex_edges_, vertices_.slots());
    grow_to(vertex_triangles_, vertices_.slots());
    vertex_attributes_->resize(vertices_.slots());
  } else {
    vertex_attributes_->reset(slot);
  }
  positions_[slot] = position;
  return Vertex(slot);
}

Triangle SurfaceMesh::add_triangle(Vertex a, Vertex b, Vertex c, Labels labels) {
  for (Vertex v : {a, b, c}) require_alive(v, "add a triangle");
  if (a == b || b == c || c == a)
    throw MeshError("cannot add a triangle: vertex " + std::to_string((a == b ? a : c).index()) +
                    " is named twice; its three vertices have to differ");
  require_labels(labels, "add a triangle");
  const std::uint32_t slot = triangles_.take();
  const Triangle t(slot);
  if (triangles_.slots() > labels_.size()) {
    grow_to(triangle_vertices_, triangles_.slots());
    grow_to(triangle_edges_, triangles_.slots());
    grow_to(labels_, triangles_.slots());
    triangle_attributes_->resize(triangles_.slots());
  } else {
    triangle_attributes_->reset(slot);
  }
  triangle_vertices_[slot] = {a, b, c};
  triangle_edges_[slot] = {edge_between(b, c), edge_between(c, a), edge_between(a, b)};
  labels_[slot] = labels;
  for (Vertex v : {a, b, c}) vertex_triangles_[v.index()].push_back(t);
  for (Edge e : triangle_edges_[slot]) edge_triangles_[e.index()].push_back(t);
  return t;
}

void SurfaceMesh::remove_triangle(Triangle t) {
  if (!alive(t)) throw MeshError("cannot remove triangle " + std::to_string(t.index()) + ": it does not exist");
  for (Vertex v : vertices(t)) erase_keeping_order(vertex_triangles_[v.index()], t);
  for (Edge e : edges(t)) {
    erase_keeping_order(edge_triangles_[e.index()], t);
    if (edge_triangles_[e.index()].empty()) remove_edge(e);
  }
  triangles_.give_back(t.index());
}

void SurfaceMesh::remove_vertex(Vertex v) {
  require_alive(v, "remove a vertex");
  if (!vertex_triangles_[v.index()].empty())
    throw MeshError("cannot remove vertex " + std::to_string(v.index()) + ": " +
                    std::to_string(vertex_triangles_[v.index()].size()) + " triangles still use it");
  vertices_.give_back(v.index());
}

void SurfaceMesh::set_labels(Triangle t, Labels labels) {
  require_labels(labels, "label a triangle");
  labels_[t.index()] = labels;
}

Edge SurfaceMesh::find_edge(Vertex a, Vertex b) const {
  if (vertex_edges_[b.index()].size() < vertex_edges_[a.index()].size()) std::swap(a, b);
  for (Edge e : edges(a)) {
    const auto& ends = vertices(e);
    if (ends[0] == b || ends[1] == b) return e;
  }
  return {};
}

Edge SurfaceMesh::edge_between(Vertex a, Vertex b) {
  if (const Edge found = find_edge(a, b); found.valid()) return found;
  const std::uint32_t slot = edges_.take();
  if (edges_.slots() > edge_vertices_.size()) {
    grow_to(edge_vertices_, edges_.slots());
    grow_to(edge_triangles_, edges_.slots());
    edge_attributes_->resize(edges_.slots());
  } else {
    edge_attributes_->reset(slot);
  }
  edge_vertices_[slot] = {a, b};
  vertex_edges_[a.index()].push_back(Edge(slot));
  vertex_edges_[b.index()].push_back(Edge(slot));
  return Edge(slot);
}

void SurfaceMesh::remove_edge(Edge e) {
  for (Vertex v : vertices(e)) erase_keeping_order(vertex_edges_[v.index()], e);
  edges_.give_back(e.index());
}

Vertex SurfaceMesh::opposite_vertex(Triangle t, Edge e) const {
  const auto& its_edges = edges(t);
  for (int i = 0; i < 3; ++i)
    if (its_edges[i] == e) return vertices(t)[i];
  return {};
}

Vertex SurfaceMesh::other_vertex(Edge e, Vertex v) const {
  const auto& ends = vertices(e);
  return ends[0] == v ? ends[1] : ends[0];
}

bool SurfaceMesh::runs_along(Triangle t, Edge e) const {
  const auto& corners = vertices(t);
  const auto& ends = vertices(e);
  for (int i = 0; i < 3; ++i)
    if (corners[i] == ends[0]) return corners[(i + 1) % 3] == ends[1];
  return false;
}

bool SurfaceMesh::is_junction(Vertex v) const {
  return std::ranges::any_of(edges(v), [this](Edge e) { return is_junction(e); });
}

void SurfaceMesh::require_alive(Vertex v, const char* doing) const {
  if (!alive(v))
    throw MeshError(std::string("cannot ") + doing + ": vertex " + std::to_string(v.index()) + " does not exist");
}

void SurfaceMesh::require_labels(Labels labels, const char* doing) const {
  if (!labels.p.valid() || !labels.q.valid() || labels.p == labels.q)
    throw MeshError(std::string("cannot ") + doing + ": labels (" + std::to_string(labels.p.index()) + ", " +
                    std::to_string(labels.q.index()) + "); a film separates two different regions");
}

}  // namespace lostopos
