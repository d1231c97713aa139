#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <memory>
#include <span>
#include <vector>

#include "LosTopos/mesh/attribute.h"
#include "LosTopos/mesh/carry.h"
#include "LosTopos/mesh/element_range.h"
#include "LosTopos/mesh/handles.h"
#include "LosTopos/mesh/slot_pool.h"
#include "LosTopos/vec3.h"

namespace lostopos {

enum class SlotOrder {
  as_before,
  by_place,  ///< what is near in space is near in memory, too
};

/// A labelled, non-manifold triangle mesh: films between regions, meeting at edges that any number of triangles share.
///
/// Edges exist exactly as long as a triangle uses them; vertices live until they are removed. Slots of removed elements
/// are used again; `compact` closes the gaps. Incidence lists keep the order of insertion, so that every sum over a
/// neighbourhood is repeatable to the bit.
class SurfaceMesh {
 public:
  using EdgeList = boost::container::small_vector<Edge, 8>;
  using TriangleList = boost::container::small_vector<Triangle, 8>;
  using EdgeTriangleList = boost::container::small_vector<Triangle, 2>;

  /// Everything that determines the mesh to the bit: slots, gaps, order of incidence, and the values of the named
  /// attributes. For checkpoints, and for steps that can be undone.
  struct State;

  SurfaceMesh();
  SurfaceMesh(SurfaceMesh&&) noexcept = default;
  SurfaceMesh& operator=(SurfaceMesh&&) noexcept = default;
  SurfaceMesh(const SurfaceMesh&) = delete;
  SurfaceMesh& operator=(const SurfaceMesh&) = delete;
  ~SurfaceMesh() = default;

  /// A copy of geometry, connectivity and labels; attributes stay with the original.
  SurfaceMesh clone() const;
  State state() const;
  /// Throws MeshError when the state is not consistent. The attributes' values wait for attributes of their names.
  static SurfaceMesh from_state(const State& state);
  /// The same as `state`, into one that is there, whose memory is used again.
  void save(State& state) const;
  /// Becomes as the state says, in place: named attributes get their values back, those that the state does not know
  /// their initial ones; values of names that are not here wait. Attributes without a name keep what is in their slots.
  /// `state` must be consistent, as those of `save` and `state` are. Throws MeshError when an attribute's type or
  /// length does not fit; the mesh is then of no use.
  void restore(const State& state);

  /// @name Building
  ///@{
  void reserve(std::size_t vertices, std::size_t triangles);
  Vertex add_vertex(const Vec3& position);
  /// Adds triangle (a, b, c) between regions labels.p (behind) and labels.q (in front of its right-hand normal), with
  /// the edges that are missing. Throws MeshError for dead or equal vertices and for equal labels.
  Triangle add_triangle(Vertex a, Vertex b, Vertex c, Labels labels);
  /// Removes a triangle and those of its edges that no other triangle uses. Its vertices stay.
  void remove_triangle(Triangle t);
  /// Throws MeshError when a triangle still uses v.
  void remove_vertex(Vertex v);
  void set_labels(Triangle t, Labels labels);
  ///@}

  /// @name Counts and ranges of the living elements
  ///@{
  std::size_t vertex_count() const { return vertices_.living(); }
  std::size_t edge_count() const { return edges_.living(); }
  std::size_t triangle_count() const { return triangles_.living(); }
  ElementRange<Vertex> vertices() const { return ElementRange<Vertex>(vertices_.alive()); }
  ElementRange<Edge> edges() const { return ElementRange<Edge>(edges_.alive()); }
  ElementRange<Triangle> triangles() const { return ElementRange<Triangle>(triangles_.alive()); }
  /// One more than the largest index in use: the size of arrays indexed by handle.
  std::size_t vertex_slots() const { return vertices_.slots(); }
  std::size_t edge_slots() const { return edges_.slots(); }
  std::size_t triangle_slots() const { return triangles_.slots(); }
  bool alive(Vertex v) const { return vertices_.is_alive(v.index()); }
  bool alive(Edge e) const { return edges_.is_alive(e.index()); }
  bool alive(Triangle t) const { return triangles_.is_alive(t.index()); }
  ///@}

  /// @name Geometry and labels
  ///@{
  const Vec3& position(Vertex v) const { return positions_[v.index()]; }
  void set_position(Vertex v, const Vec3& x) { positions_[v.index()] = x; }
  /// Positions of all slots, indexed by vertex handle.
  std::span<const Vec3> positions() const { return positions_; }
  Labels labels(Triangle t) const { return labels_[t.index()]; }
  ///@}

  /// @name Incidence
  ///@{
  const std::array<Vertex, 3>& vertices(Triangle t) const { return triangle_vertices_[t.index()]; }
  /// The edge at place i lies opposite to the vertex at place i.
  const std::array<Edge, 3>& edges(Triangle t) const { return triangle_edges_[t.index()]; }
  const std::array<Vertex, 2>& vertices(Edge e) const { return edge_vertices_[e.index()]; }
  std::span<const Triangle> triangles(Edge e) const { return view(edge_triangles_[e.index()]); }
  std::span<const Triangle> triangles(Vertex v) const { return view(vertex_triangles_[v.index()]); }
  std::span<const Edge> edges(Vertex v) const { return view(vertex_edges_[v.index()]); }
  /// The edge between a and b, or an invalid handle.
  Edge find_edge(Vertex a, Vertex b) const;
  Vertex opposite_vertex(Triangle t, Edge e) const;
  Vertex other_vertex(Edge e, Vertex v) const;
  /// True when triangle t runs along e from vertices(e)[0] to vertices(e)[1].
  bool runs_along(Triangle t, Edge e) const;
  /// More than two triangles meet at e (a Plateau border when exactly three).
  bool is_junction(Edge e) const { return triangles(e).size() > 2; }
  bool is_junction(Vertex v) const;
  ///@}

  /// @name Attributes and memory
  /// With a name, values are carried through operations by `policy` (see carry.h), and are saved and written; the name
  /// is the only one of its kind on this mesh, else MeshError is thrown. Values that wait under it (see `restore`) are
  /// taken, where `initial` is given to the others. Without a name they are working memory that nothing carries.
  ///@{
  template <class T, class Policy>
  VertexAttribute<T> add_vertex_attribute(std::string name, Policy policy, T initial = T()) {
    return {vertex_attributes_, std::move(name), carry::make_policy<Vertex, T>(std::move(policy)), std::move(initial)};
  }
  template <class T, class Policy>
  EdgeAttribute<T> add_edge_attribute(std::string name, Policy policy, T initial = T()) {
    return {edge_attributes_, std::move(name), carry::make_policy<Edge, T>(std::move(policy)), std::move(initial)};
  }
  template <class T, class Policy>
  TriangleAttribute<T> add_triangle_attribute(std::string name, Policy policy, T initial = T()) {
    return {triangle_attributes_, std::move(name), carry::make_policy<Triangle, T>(std::move(policy)),
            std::move(initial)};
  }
  template <class T>
  VertexAttribute<T> add_vertex_attribute(T initial = T()) {
    return VertexAttribute<T>(vertex_attributes_, std::move(initial));
  }
  template <class T>
  EdgeAttribute<T> add_edge_attribute(T initial = T()) {
    return EdgeAttribute<T>(edge_attributes_, std::move(initial));
  }
  template <class T>
  TriangleAttribute<T> add_triangle_attribute(T initial = T()) {
    return TriangleAttribute<T>(triangle_attributes_, std::move(initial));
  }
  /// The named attributes, in the order in which they were added, for writers.
  std::span<NamedAttributeColumn* const> named_vertex_attributes() const { return vertex_attributes_->named(); }
  std::span<NamedAttributeColumn* const> named_triangle_attributes() const { return triangle_attributes_->named(); }
  /// Tells the named attributes of an operation; to be called by what carries it out, before and after.
  template <class Event>
  void carry_attributes(void (OperationObserver::*hook)(const SurfaceMesh&, const Event&), const Event& event) {
    vertex_attributes_->carry(hook, *this, event);
    edge_attributes_->carry(hook, *this, event);
    triangle_attributes_->carry(hook, *this, event);
  }
  /// Closes the gaps that removed elements left and renumbers all handles; attributes follow.
  void compact(SlotOrder order = SlotOrder::as_before);
  /// Bytes held on the heap, attributes included.
  std::size_t memory_bytes() const;
  ///@}

 private:
  template <class List>
  static std::span<const typename List::value_type> view(const List& list) {
    return {list.data(), list.size()};
  }
  Edge edge_between(Vertex a, Vertex b);
  void remove_edge(Edge e);
  void require_alive(Vertex v, const char* doing) const;
  void require_labels(Labels labels, const char* doing) const;

  SlotPool vertices_, edges_, triangles_;
  std::vector<Vec3> positions_;
  std::vector<EdgeList> vertex_edges_;
  std::vector<TriangleList> vertex_triangles_;
  std::vector<std::array<Vertex, 2>> edge_vertices_;
  std::vector<EdgeTriangleList> edge_triangles_;
  std::vector<std::array<Vertex, 3>> triangle_vertices_;
  std::vector<std::array<Edge, 3>> triangle_edges_;
  std::vector<Labels> labels_;
  std::shared_ptr<AttributeRegistry> vertex_attributes_, edge_attributes_, triangle_attributes_;
};

struct SurfaceMesh::State {
  SlotPool vertices, edges, triangles;
  std::vector<Vec3> positions;
  std::vector<EdgeList> vertex_edges;
  std::vector<TriangleList> vertex_triangles;
  std::vector<std::array<Vertex, 2>> edge_vertices;
  std::vector<EdgeTriangleList> edge_triangles;
  std::vector<std::array<Vertex, 3>> triangle_vertices;
  std::vector<std::array<Edge, 3>> triangle_edges;
  std::vector<Labels> labels;
  std::vector<StoredAttribute> vertex_attributes, edge_attributes, triangle_attributes;
};

/// Throws MeshError when the lengths of the state's arrays differ, or a list refers to an element that is not alive.
void require_consistent(const SurfaceMesh::State& state);

}  // namespace lostopos
