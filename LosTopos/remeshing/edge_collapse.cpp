#include "LosTopos/remeshing/edge_collapse.h"

#include <algorithm>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/invariants/connectivity.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/remeshing/invariants/volume.h"
#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

constexpr std::array collapse_invariants = {
    Invariant{Refusal::inverted_normal, keeps_orientation}, Invariant{Refusal::long_edge, keeps_longest_edge},
    Invariant{Refusal::small_angle, keeps_min_angle},       Invariant{Refusal::large_angle, keeps_max_angle},
    Invariant{Refusal::small_area, keeps_min_area},         Invariant{Refusal::volume_change, keeps_volumes},
};

// The shift that keeps the volumes is left out when it is more than this part of the collapsed edge.
constexpr double largest_shift = 0.5;

bool has_edge(const SurfaceMesh& mesh, Triangle t, Edge e) {
  return std::ranges::find(mesh.edges(t), e) != mesh.edges(t).end();
}

// The end that is held less, if one is, goes to where the other is held as well: it leaves no wall that it is in.
bool stays_in_walls(const SurfaceMesh& mesh, Vertex a, Hold hold_a, Vertex b, Hold hold_b) {
  if (hold_a == Hold::none || hold_b == Hold::none) return true;
  const Hold common = common_hold(hold_a, mesh.position(a), hold_b, mesh.position(b));
  return common == hold_a || common == hold_b;
}

}  // namespace

// Which end stays, and where between the two.
std::optional<Refusal> EdgeCollapse::choose_ends(Edge e) {
  const auto [a, b] = c_.mesh.vertices(e);
  const Hold hold_a = c_.held[a], hold_b = c_.held[b];
  if (is_held(hold_a) && is_held(hold_b)) return Refusal::held;
  if (!c_.options.collapse_to_held && (is_held(hold_a) || is_held(hold_b))) return Refusal::held;
  if (!stays_in_walls(c_.mesh, a, hold_a, b, hold_b)) return Refusal::held;
  const bool more_a = !holds_all_of(hold_b, hold_a), more_b = !holds_all_of(hold_a, hold_b);
  if (!keeps_junctions(c_.mesh, e)) return Refusal::junction_topology;
  const VertexRank rank_a = rank(c_.mesh, a), rank_b = rank(c_.mesh, b);
  const bool a_stays = more_a || (!more_b && (rank_a > rank_b || (rank_a == rank_b && a < b)));
  kept_ = a_stays ? a : b;
  removed_ = a_stays ? b : a;
  const bool equals = rank_a == rank_b && !more_a && !more_b;
  t_ = equals ? 0.5 : 0;
  // A vertex that is held more but bound less would pull the curve off its place.
  if ((a_stays ? rank_a : rank_b) < (a_stays ? rank_b : rank_a)) return Refusal::held;
  return {};
}

// Both stars with the result still on the edge.
void EdgeCollapse::plan_on_edge(Edge e) {
  const SurfaceMesh& mesh = c_.mesh;
  c_.plan.clear();
  for (Triangle t : mesh.triangles(removed_)) {
    c_.plan.replaced.push_back(t);
    if (!has_edge(mesh, t, e)) c_.plan.add_moved(mesh, t, removed_, kept_, position_);
  }
  if (t_ == 0) return;
  for (Triangle t : mesh.triangles(kept_)) {
    if (has_edge(mesh, t, e)) continue;
    c_.plan.replaced.push_back(t);
    c_.plan.add_moved(mesh, t, kept_, kept_, position_);
  }
}

Vec3 EdgeCollapse::volume_keeping_position(Edge e) const {
  if (t_ == 0) return position_;
  const Vec3 shift = VolumeChange(c_.mesh, c_.plan, kept_).restoring_shift(c_.held[kept_]);
  const bool small = shift.norm() <= largest_shift * length(c_.mesh, e);
  return small ? Vec3(position_ + shift) : position_;
}

// First the ends come together along the edge, then the result moves off it.
bool EdgeCollapse::motions_are_free(Edge e, const Vec3& on_edge) {
  const SurfaceMesh& mesh = c_.mesh;
  c_.motion.clear();
  auto add = [&](Triangle t) {
    StarMotion::Points points;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex v = mesh.vertices(t)[i];
      const bool moves = v == removed_ || (v == kept_ && t_ != 0);
      points[i] = {v, {mesh.position(v), moves ? on_edge : mesh.position(v)}, moves};
    }
    c_.motion.add(points);
  };
  for (Triangle t : mesh.triangles(removed_)) add(t);
  if (t_ != 0)
    for (Triangle t : mesh.triangles(kept_))
      if (!has_edge(mesh, t, e)) add(t);
  const std::array<Vertex, 2> ends = {kept_, removed_};
  if (!c_.guard.is_free(c_.motion, {ends, Edge()})) return false;
  if (position_ == on_edge) return true;
  c_.motion.clear();
  c_.plan.move(kept_, on_edge);
  c_.motion.add_planned_star(c_.plan, kept_, position_);
  c_.plan.move(kept_, position_);
  return c_.guard.is_free(c_.motion, {ends, Edge()});
}

std::optional<Refusal> EdgeCollapse::check(Edge e) {
  if (const auto refusal = choose_ends(e)) return refusal;
  if (!meets_link_condition(c_.mesh, e)) return Refusal::link_condition;
  const Vec3 on_edge = (1 - t_) * c_.mesh.position(kept_) + t_ * c_.mesh.position(removed_);
  position_ = on_edge;
  plan_on_edge(e);
  if (c_.plan.triangles.empty()) return Refusal::link_condition;  // nothing would be left of it
  position_ = volume_keeping_position(e);
  c_.plan.move(kept_, position_);
  c_.plan.measure(c_.mesh);
  if (const auto refusal = first_broken(collapse_invariants, c_.plan, c_.limits)) return refusal;
  if (!motions_are_free(e, on_edge)) return Refusal::intersection;
  return {};
}

std::optional<Refusal> EdgeCollapse::attempt(Edge e) {
  if (const auto refusal = check(e)) return refusal;
  CollapseEvent event{e, kept_, removed_, t_, position_, {}};
  c_.notify(&OperationObserver::before_collapse, event);
  c_.mesh.set_position(kept_, position_);
  event.triangles = c_.carry_out();
  c_.mesh.remove_vertex(removed_);
  c_.notify(&OperationObserver::after_collapse, event);
  return {};
}

}  // namespace lostopos
