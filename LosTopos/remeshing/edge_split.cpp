#include "LosTopos/remeshing/edge_split.h"

#include "LosTopos/mesh/hold.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/remeshing/invariants/volume.h"
#include "LosTopos/remeshing/smooth_position.h"
#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

constexpr std::array split_invariants = {
    Invariant{Refusal::inverted_normal, keeps_orientation}, Invariant{Refusal::small_angle, keeps_min_angle},
    Invariant{Refusal::large_angle, keeps_max_angle},       Invariant{Refusal::small_area, keeps_min_area},
    Invariant{Refusal::volume_change, keeps_volumes},
};

}  // namespace

std::optional<Refusal> EdgeSplit::plan_at(Edge e, const Vec3& position) {
  const auto [a, b] = c_.mesh.vertices(e);
  const Vec3 midpoint = 0.5 * (c_.mesh.position(a) + c_.mesh.position(b));
  c_.plan.clear();
  for (Triangle t : c_.mesh.triangles(e)) {
    c_.plan.replaced.push_back(t);
    c_.plan.add_moved(c_.mesh, t, b, planned_vertex, midpoint);
    c_.plan.add_moved(c_.mesh, t, a, planned_vertex, midpoint);
  }
  c_.motion.clear();
  c_.motion.add_planned_star(c_.plan, planned_vertex, position);
  c_.plan.move(planned_vertex, position);
  c_.plan.measure(c_.mesh);
  position_ = position;
  if (const auto refusal = first_broken(split_invariants, c_.plan, c_.limits)) return refusal;
  if (!c_.guard.is_free(c_.motion, {{}, e})) return Refusal::intersection;
  return {};
}

// The coordinates that both ends hold stay.
Vec3 EdgeSplit::in_common_walls(Edge e, Vec3 position) const {
  const auto [a, b] = c_.mesh.vertices(e);
  const Vec3& x = c_.mesh.position(a);
  const Hold common = common_hold(c_.held[a], x, c_.held[b], c_.mesh.position(b));
  for (int i = 0; i < 3; ++i)
    if (holds(common, i)) position[i] = x[i];
  return position;
}

std::optional<Refusal> EdgeSplit::check(Edge e) {
  const auto [a, b] = c_.mesh.vertices(e);
  if (is_held(c_.held[a]) && is_held(c_.held[b])) return Refusal::held;
  if (c_.options.use_butterfly) {
    const auto smooth = is_border(c_.mesh, e) ? border_position(c_.mesh, e) : butterfly_position(c_.mesh, e);
    if (smooth && !plan_at(e, in_common_walls(e, *smooth))) return {};
  }
  return plan_at(e, 0.5 * (c_.mesh.position(a) + c_.mesh.position(b)));
}

std::optional<Refusal> EdgeSplit::attempt(Edge e) {
  if (const auto refusal = check(e)) return refusal;
  SplitEvent event{e, c_.mesh.vertices(e), Vertex(), position_, {}};
  c_.notify(&OperationObserver::before_split, event);
  added_ = event.added = c_.mesh.add_vertex(position_);
  event.triangles = c_.carry_out(added_);
  c_.notify(&OperationObserver::after_split, event);
  return {};
}

}  // namespace lostopos
