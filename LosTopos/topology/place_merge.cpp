#include "LosTopos/topology/place_merge.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/remeshing/hold_transfer.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/topology/coincident_triangles.h"

namespace lostopos {
namespace {

template <class Range, class T>
bool contains(const Range& range, const T& value) {
  return std::ranges::find(range, value) != std::ranges::end(range);
}

bool are_joined(const SurfaceMesh& mesh, const std::array<Site, 2>& sites) {
  return sites[0].vertex.valid() && sites[1].vertex.valid() && mesh.find_edge(sites[0].vertex, sites[1].vertex).valid();
}

void collect_vertices(const SurfaceMesh& mesh, const SurfaceMesh::TriangleList& triangles,
                      std::vector<Vertex>& vertices) {
  vertices.clear();
  for (Triangle t : triangles) vertices.insert(vertices.end(), mesh.vertices(t).begin(), mesh.vertices(t).end());
  base::sort_unique(vertices);
}

bool have_common(const std::vector<Vertex>& a, const std::vector<Vertex>& b) {
  return std::ranges::any_of(a, [&](Vertex v) { return std::ranges::binary_search(b, v); });
}

// Whether the sites are held in one coordinate at two values: in opposite walls.
bool leaves_wall(const SurfaceMesh& mesh, const std::array<Site, 2>& sites, const std::array<Hold, 2>& holds_of) {
  const Vec3 &x = mesh.position(sites[0].place.vertices[0]), &y = mesh.position(sites[1].place.vertices[0]);
  for (int i = 0; i < 3; ++i)
    if (holds(holds_of[0], i) && holds(holds_of[1], i) && x[i] != y[i]) return true;
  return false;
}

}  // namespace

// The place that is bound more stays where it is; equals meet in the middle.
std::optional<Refusal> PlaceMerge::choose_position() {
  const std::array<bool, 2> held = {is_held(c_.held, sites_[0]), is_held(c_.held, sites_[1])};
  if (held[0] && held[1]) return Refusal::held;
  // The middle of a held wire or solid must not get a vertex that belongs to a film only.
  for (std::size_t i = 0; i < 2; ++i)
    if (held[i] && !sites_[i].vertex.valid()) return Refusal::held;
  const std::array<Hold, 2> holds_of = {common_hold(c_.mesh, c_.held.slots(), sites_[0].place),
                                        common_hold(c_.mesh, c_.held.slots(), sites_[1].place)};
  if (leaves_wall(c_.mesh, sites_, holds_of)) return Refusal::held;
  const std::array<bool, 2> bound = {held[0] || !holds_all_of(holds_of[1], holds_of[0]),
                                     held[1] || !holds_all_of(holds_of[0], holds_of[1])};
  if (bound[0] && bound[1]) return Refusal::held;
  const VertexRank rank0 = rank(c_.mesh, sites_[0]), rank1 = rank(c_.mesh, sites_[1]);
  t_ = 0.5;
  if (bound[0] || (!bound[1] && rank0 > rank1)) t_ = 0;
  if (bound[1] || (!bound[0] && rank1 > rank0)) t_ = 1;
  position_ = (1 - t_) * sites_[0].point + t_ * sites_[1].point;
  if (t_ == 0) position_ = sites_[0].point;
  if (t_ == 1) position_ = sites_[1].point;
  for (std::size_t k = 0; k < 2; ++k)
    for (int i = 0; i < 3; ++i)
      if (holds(holds_of[k], i)) position_[i] = c_.mesh.position(sites_[k].place.vertices[0])[i];  // to the bit
  const Vertex a = sites_[0].vertex, b = sites_[1].vertex;
  if (a.valid() && b.valid())
    kept_ = bound[0] || (!bound[1] && a < b) ? a : b;
  else
    kept_ = a.valid() ? a : b.valid() ? b : planned_vertex;
  return {};
}

std::optional<Refusal> PlaceMerge::require_apart(const Rules& rules) const {
  if (std::ranges::any_of(sites_[0].vertices(), [this](Vertex v) { return sites_[1].uses(v); }))
    return Refusal::link_condition;
  if (are_joined(c_.mesh, sites_)) {
    if (!rules.joined_vertices) return Refusal::link_condition;
    return {};
  }
  if (std::ranges::any_of(stars_[0], [this](Triangle t) { return contains(stars_[1], t); }))
    return Refusal::link_condition;
  if (rules.min_transversality <= 0) return {};
  std::vector<Vertex> near0, near1;
  collect_vertices(c_.mesh, stars_[0], near0);
  collect_vertices(c_.mesh, stars_[1], near1);
  if (!have_common(near0, near1)) return {};
  for (const Site& site : sites_)
    if (transversality(c_.mesh, site, rules.direction) < rules.min_transversality) return Refusal::not_better;
  return {};
}

void PlaceMerge::plan_star(const Site& site) {
  const SurfaceMesh& mesh = c_.mesh;
  for (Triangle t : triangles_at(mesh, site)) {
    if (contains(c_.plan.replaced, t)) continue;  // at both places: its triangle collapses
    c_.plan.replaced.push_back(t);
    const auto& corners = mesh.vertices(t);
    const bool at_both = sites_[0].vertex.valid() && sites_[1].vertex.valid() && contains(corners, sites_[0].vertex) &&
                         contains(corners, sites_[1].vertex);
    if (at_both) continue;
    for (Vertex v : site.vertices()) c_.plan.add_moved(mesh, t, v, kept_, position_);
  }
}

// Where a film ends, at a wire, it is not said which regions meet beyond its end: there the film has to stay alone.
bool PlaceMerge::keeps_open_edges() const {
  const SurfaceMesh& mesh = c_.mesh;
  for (const Site& site : sites_)
    if (site.edge.valid() && mesh.triangles(site.edge).size() == 1) return false;
  auto renamed = [&](Vertex v) {
    return (sites_[0].vertex == v && v.valid()) || (sites_[1].vertex == v && v.valid()) ? kept_ : v;
  };
  for (Triangle t : c_.plan.replaced) {
    for (Edge e : mesh.edges(t)) {
      if (mesh.triangles(e).size() != 1) continue;
      const Vertex a = renamed(mesh.vertices(e)[0]), b = renamed(mesh.vertices(e)[1]);
      std::size_t here = 0;
      for (const PlannedTriangle& planned : c_.plan.triangles)
        if (contains(planned.vertices, a) && contains(planned.vertices, b))
          here += planned.parent == t && planned.labels == mesh.labels(t) ? 1 : 2;
      if (a == b || here != 1) return false;
    }
  }
  return true;
}

void PlaceMerge::plan_motion() {
  c_.motion.clear();
  const std::array<Vertex, 2> names = {sites_[0].vertex.valid() ? sites_[0].vertex : planned_vertex,
                                       sites_[1].vertex.valid() ? sites_[1].vertex : second_planned_vertex};
  for (std::size_t k = 0; k < 2; ++k) {
    if (sites_[k].point == position_ && sites_[k].vertex.valid()) continue;
    const MovingPoint mover = {names[k], {sites_[k].point, position_}, true};
    for (Triangle t : stars_[k]) {
      for (Vertex replaced : sites_[k].vertices()) {
        StarMotion::Points points;
        for (std::size_t i = 0; i < 3; ++i) {
          const Vertex v = c_.mesh.vertices(t)[i];
          const Vec3& x = c_.mesh.position(v);
          points[i] = {v, {x, x}, false};
          if (v == replaced) points[i] = mover;
          if (v == names[1 - k]) points[i] = {v, {x, position_}, x != position_};
        }
        c_.motion.add(points);
      }
    }
  }
}

std::optional<Refusal> PlaceMerge::check(const Rules& rules) {
  for (std::size_t k = 0; k < 2; ++k) stars_[k] = triangles_at(c_.mesh, sites_[k]);
  if (const auto refusal = require_apart(rules)) return refusal;
  if (const auto refusal = choose_position()) return refusal;
  c_.plan.clear();
  for (const Site& site : sites_) plan_star(site);
  const auto cancelled = cancel_coincident(c_.plan);
  if (!cancelled) return Refusal::labels;
  cancelled_ = *cancelled;
  if (!keeps_open_edges()) return Refusal::junction_topology;
  c_.plan.measure(c_.mesh);
  if (rules.keeps_orientation) {
    if (!keeps_orientation(c_.plan, c_.limits)) return Refusal::inverted_normal;
    if (!keeps_min_angle(c_.plan, c_.limits)) return Refusal::small_angle;
  }
  plan_motion();
  boost::container::small_vector<Vertex, 2> ends;
  for (const Site& site : sites_)
    if (site.vertex.valid()) ends.push_back(site.vertex);
  const IntersectionGuard::LeftOut left_out = {
      {ends.data(), ends.size()}, sites_[0].edge, sites_[1].edge, {sites_[0].triangle, sites_[1].triangle}};
  if (!c_.guard.is_free(c_.motion, left_out)) return Refusal::intersection;
  return {};
}

void PlaceMerge::carry_out() {
  touched_.clear();
  for (Triangle t : c_.plan.replaced)
    touched_.insert(touched_.end(), c_.mesh.vertices(t).begin(), c_.mesh.vertices(t).end());
  const bool is_new = kept_ == planned_vertex;
  MergeEvent event{{sites_[0].place, sites_[1].place}, t_, is_new ? Vertex() : kept_, position_, {}, {}};
  c_.notify(&OperationObserver::before_merge, event);
  if (is_new)
    result_ = c_.mesh.add_vertex(position_);
  else
    c_.mesh.set_position(result_ = kept_, position_);
  event.result = result_;
  event.triangles = c_.carry_out(result_);
  touched_.push_back(result_);
  base::sort_unique(touched_);
  removed_.clear();
  for (Vertex v : touched_)
    if (c_.mesh.triangles(v).empty()) removed_.push_back(v);
  for (Vertex v : removed_) c_.mesh.remove_vertex(v);
  event.removed = removed_;
  c_.notify(&OperationObserver::after_merge, event);
  if (contains(removed_, result_)) result_ = Vertex();
}

std::optional<Refusal> PlaceMerge::attempt(const Site& a, const Site& b, const Rules& rules) {
  sites_ = {a, b};
  if (const auto refusal = check(rules)) return refusal;
  carry_out();
  return {};
}

}  // namespace lostopos
