// Copies, checkpoints, compaction and memory of the mesh: everything that treats its arrays as a whole.
#include <algorithm>
#include <string>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit_links.h"
#include "LosTopos/mesh/place_order.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {
namespace {

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& old_slot_of_new, std::size_t old_slots) {
  std::vector<std::uint32_t> new_slot_of_old(old_slots, Vertex::invalid_index);
  for (std::uint32_t i = 0; i < old_slot_of_new.size(); ++i) new_slot_of_old[old_slot_of_new[i]] = i;
  return new_slot_of_old;
}

// By the least of their vertices' new slots.
template <class Corners>
void sort_by_first_vertex(std::vector<std::uint32_t>& slots, const std::vector<Corners>& vertices,
                          const std::vector<std::uint32_t>& new_vertex) {
  sort_slots(slots, [&](std::uint32_t slot) {
    std::uint32_t first = Vertex::invalid_index;
    for (Vertex v : vertices[slot]) first = std::min(first, new_vertex[v.index()]);
    return first;
  });
}

template <class T>
void gather(std::vector<T>& values, const std::vector<std::uint32_t>& old_slot_of_new) {
  std::vector<T> kept;
  kept.reserve(old_slot_of_new.size());
  for (std::uint32_t old : old_slot_of_new) kept.push_back(std::move(values[old]));
  values = std::move(kept);
}

template <class Lists>
void renumber(Lists& lists, const std::vector<std::uint32_t>& new_slot_of_old) {
  for (auto& list : lists) {
    for (auto& element : list) element = std::remove_reference_t<decltype(element)>(new_slot_of_old[element.index()]);
    if constexpr (requires { list.shrink_to_fit(); }) list.shrink_to_fit();
  }
}

template <class T>
std::size_t array_bytes(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

// Lists too long for their inline storage own a block on the heap.
template <class List>
std::size_t list_bytes(const std::vector<List>& lists) {
  std::size_t bytes = array_bytes(lists);
  for (const List& list : lists)
    if (list.capacity() > List::static_capacity) bytes += list.capacity() * sizeof(typename List::value_type);
  return bytes;
}

[[noreturn]] void refuse(const char* what, std::size_t slot, const char* message) {
  throw MeshError(std::string("mesh state: ") + what + " " + std::to_string(slot) + " " + message);
}

// The slots that are not in use are the free ones, each once.
void require_sound(const SlotPool& pool, const char* what) {
  std::vector<char> in_use = pool.alive();
  for (std::uint32_t slot : pool.free()) {
    if (slot >= in_use.size() || in_use[slot] != 0)
      refuse(what, slot, "is free, and in use, or twice free, or not there");
    in_use[slot] = 1;
  }
  for (std::size_t slot = 0; slot < in_use.size(); ++slot)
    if (in_use[slot] != 1) refuse(what, slot, "is neither in use nor free");
}

// What takes a free slot into use finds its lists empty.
template <class Lists>
void require_empty_where_free(const Lists& lists, const SlotPool& pool, const char* what) {
  for (std::uint32_t slot : pool.free())
    if (!lists[slot].empty()) refuse(what, slot, "is not in use, and has neighbours");
}

void require_lengths(const std::vector<StoredAttribute>& attributes, std::size_t slots, const char* what) {
  for (const auto& [name, values] : attributes)
    if (!values || values->size() != slots)
      throw MeshError(std::string("mesh state: ") + what + " attribute '" + name + "' has not a value for each slot");
}

}  // namespace

void require_consistent(const SurfaceMesh::State& s) {
  const std::size_t nv = s.vertices.slots(), ne = s.edges.slots(), nt = s.triangles.slots();
  if (s.positions.size() != nv || s.vertex_edges.size() != nv || s.vertex_triangles.size() != nv ||
      s.edge_vertices.size() != ne || s.edge_triangles.size() != ne || s.triangle_vertices.size() != nt ||
      s.triangle_edges.size() != nt || s.labels.size() != nt)
    throw MeshError("mesh state: its arrays differ in length");
  require_sound(s.vertices, "vertex");
  require_sound(s.edges, "edge");
  require_sound(s.triangles, "triangle");
  require_empty_where_free(s.vertex_edges, s.vertices, "vertex");
  require_empty_where_free(s.vertex_triangles, s.vertices, "vertex");
  require_empty_where_free(s.edge_triangles, s.edges, "edge");
  require_lengths(s.vertex_attributes, nv, "vertex");
  require_lengths(s.edge_attributes, ne, "edge");
  require_lengths(s.triangle_attributes, nt, "triangle");
}

SurfaceMesh SurfaceMesh::clone() const {
  State copy = state();
  for (auto* attributes : {&copy.vertex_attributes, &copy.edge_attributes, &copy.triangle_attributes})
    attributes->clear();
  SurfaceMesh mesh;
  mesh.restore(copy);
  return mesh;
}

SurfaceMesh::State SurfaceMesh::state() const {
  State copy;
  save(copy);
  return copy;
}

void SurfaceMesh::save(State& s) const {
  s.vertices = vertices_;
  s.edges = edges_;
  s.triangles = triangles_;
  s.positions = positions_;
  s.vertex_edges = vertex_edges_;
  s.vertex_triangles = vertex_triangles_;
  s.edge_vertices = edge_vertices_;
  s.edge_triangles = edge_triangles_;
  s.triangle_vertices = triangle_vertices_;
  s.triangle_edges = triangle_edges_;
  s.labels = labels_;
  vertex_attributes_->save(s.vertex_attributes);
  edge_attributes_->save(s.edge_attributes);
  triangle_attributes_->save(s.triangle_attributes);
}

void SurfaceMesh::restore(const State& s) {
  vertices_ = s.vertices;
  edges_ = s.edges;
  triangles_ = s.triangles;
  positions_ = s.positions;
  vertex_edges_ = s.vertex_edges;
  vertex_triangles_ = s.vertex_triangles;
  edge_vertices_ = s.edge_vertices;
  edge_triangles_ = s.edge_triangles;
  triangle_vertices_ = s.triangle_vertices;
  triangle_edges_ = s.triangle_edges;
  labels_ = s.labels;
  vertex_attributes_->restore(s.vertex_attributes, vertices_.slots());
  edge_attributes_->restore(s.edge_attributes, edges_.slots());
  triangle_attributes_->restore(s.triangle_attributes, triangles_.slots());
}

SurfaceMesh SurfaceMesh::from_state(const State& state) {
  require_consistent(state);
  SurfaceMesh mesh;
  mesh.restore(state);
  // Vertices without triangles are nothing that a mesh cannot have, and what is found last.
  for (const auto& [defect, message] : audit_links(mesh, 1).findings)
    if (defect != Defect::isolated_vertex) throw MeshError(std::string("mesh state: ") + name(defect) + ": " + message);
  return mesh;
}

void SurfaceMesh::compact(SlotOrder order) {
  const std::size_t nv = vertices_.slots(), ne = edges_.slots(), nt = triangles_.slots();
  auto old_vertex = vertices_.compact(), old_edge = edges_.compact(), old_triangle = triangles_.compact();
  if (order == SlotOrder::by_place) sort_by_place(old_vertex, positions_);
  const auto new_vertex = inverse(old_vertex, nv);
  if (order == SlotOrder::by_place) {
    sort_by_first_vertex(old_edge, edge_vertices_, new_vertex);
    sort_by_first_vertex(old_triangle, triangle_vertices_, new_vertex);
  }
  const auto new_edge = inverse(old_edge, ne), new_triangle = inverse(old_triangle, nt);
  gather(positions_, old_vertex);
  gather(vertex_edges_, old_vertex);
  gather(vertex_triangles_, old_vertex);
  gather(edge_vertices_, old_edge);
  gather(edge_triangles_, old_edge);
  gather(triangle_vertices_, old_triangle);
  gather(triangle_edges_, old_triangle);
  gather(labels_, old_triangle);
  renumber(vertex_edges_, new_edge);
  renumber(vertex_triangles_, new_triangle);
  renumber(edge_vertices_, new_vertex);
  renumber(edge_triangles_, new_triangle);
  renumber(triangle_vertices_, new_vertex);
  renumber(triangle_edges_, new_edge);
  vertex_attributes_->gather(old_vertex);
  edge_attributes_->gather(old_edge);
  triangle_attributes_->gather(old_triangle);
}

std::size_t SurfaceMesh::memory_bytes() const {
  return vertices_.memory_bytes() + edges_.memory_bytes() + triangles_.memory_bytes() + array_bytes(positions_) +
         list_bytes(vertex_edges_) + list_bytes(vertex_triangles_) + array_bytes(edge_vertices_) +
         list_bytes(edge_triangles_) + array_bytes(triangle_vertices_) + array_bytes(triangle_edges_) +
         array_bytes(labels_) + vertex_attributes_->memory_bytes() + edge_attributes_->memory_bytes() +
         triangle_attributes_->memory_bytes();
}

}  // namespace lostopos
