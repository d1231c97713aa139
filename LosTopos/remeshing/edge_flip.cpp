#include "LosTopos/remeshing/edge_flip.h"

#include <Eigen/Geometry>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/remeshing/invariants/volume.h"
#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

// Of the two new triangles against the two old ones.
constexpr std::array flip_invariants = {
    Invariant{Refusal::inverted_normal, keeps_orientation},
    Invariant{Refusal::not_better, improves_min_angle},
    Invariant{Refusal::long_edge, keeps_longest_edge},
    Invariant{Refusal::small_area, keeps_min_area},
};

// With the triangles that the shift moves.
constexpr std::array shift_invariants = {
    Invariant{Refusal::inverted_normal, keeps_orientation}, Invariant{Refusal::small_angle, keeps_min_angle},
    Invariant{Refusal::large_angle, keeps_max_angle},       Invariant{Refusal::long_edge, keeps_longest_edge},
    Invariant{Refusal::small_area, keeps_min_area},         Invariant{Refusal::volume_change, keeps_volumes},
};

// The shift that keeps the volumes is left out when it is more than this part of the new edge.
constexpr double largest_end_shift = 0.1;

// What lies on the left and right of t, seen along e.
Labels labels_along(const SurfaceMesh& mesh, Triangle t, Edge e) {
  return mesh.runs_along(t, e) ? mesh.labels(t) : mesh.labels(t).flipped();
}

PlannedTriangle planned_triangle(const SurfaceMesh& mesh, const std::array<Vertex, 3>& v, Labels labels,
                                 Triangle parent, const Vec3& normal) {
  return {v, {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])}, labels, parent, normal, false};
}

// Between two walls: another edge would cut the crease off.
bool is_in_crease(const SurfaceMesh& mesh, Vertex a, Hold hold_a, Vertex b, Hold hold_b) {
  const Hold common = common_hold(hold_a, mesh.position(a), hold_b, mesh.position(b));
  return held_count(common) >= 2;
}

}  // namespace

bool EdgeFlip::is_wanted(const SurfaceMesh& mesh, Edge e) {
  // In the sine of the sum: about three degrees. Four corners close to a circle would flip back and forth for ever on a
  // surface that moves a little in every step, and every flip costs some smoothness.
  constexpr double room = 0.05;
  const auto around = mesh.triangles(e);
  if (around.size() != 2) return false;
  const Vec3 &a = mesh.position(mesh.vertices(e)[0]), &b = mesh.position(mesh.vertices(e)[1]);
  const Vec3 &c = mesh.position(mesh.opposite_vertex(around[0], e)),
             &d = mesh.position(mesh.opposite_vertex(around[1], e));
  const Vec3 ac = a - c, bc = b - c, ad = a - d, bd = b - d;
  const double cosine_c = ac.dot(bc), cosine_d = ad.dot(bd);
  if (cosine_c >= 0 && cosine_d >= 0) return false;
  const double sine_c = ac.cross(bc).norm(), sine_d = ad.cross(bd).norm();
  const double size = (std::abs(cosine_c) + sine_c) * (std::abs(cosine_d) + sine_d);
  return sine_c * cosine_d + cosine_c * sine_d < -room * size;
}

// The flip with all vertices where they are.
std::optional<Refusal> EdgeFlip::plan_flip(Edge e) {
  const SurfaceMesh& mesh = c_.mesh;
  const auto [a, b] = mesh.vertices(e);
  // t1 = (a, b, c) up to its orientation, seen from where it turns to the left; t2 = (b, a, d).
  const Triangle t1 = mesh.triangles(e)[0], t2 = mesh.triangles(e)[1];
  const Labels labels = labels_along(mesh, t1, e);
  if (labels != labels_along(mesh, t2, e).flipped()) return Refusal::labels;
  const Vertex c = mesh.opposite_vertex(t1, e), d = mesh.opposite_vertex(t2, e);
  opposite_ = {c, d};
  if (c == d || mesh.find_edge(c, d).valid()) return Refusal::link_condition;
  const Vec3 normal1 = (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
  const Vec3 normal2 = (mesh.position(a) - mesh.position(b)).cross(mesh.position(d) - mesh.position(b));
  if (!(normal1.dot(normal2) > 0)) return Refusal::inverted_normal;
  c_.plan.clear();
  c_.plan.replaced = {t1, t2};
  c_.plan.triangles.push_back(planned_triangle(mesh, {a, d, c}, labels, t1, normal1 + normal2));
  c_.plan.triangles.push_back(planned_triangle(mesh, {d, b, c}, labels, t2, normal1 + normal2));
  c_.plan.measure(mesh);
  return first_broken(flip_invariants, c_.plan, c_.limits);
}

// Lets an end of the new edge take back what the flip adds to or takes from the regions.
std::optional<Refusal> EdgeFlip::plan_shift(Edge e) {
  moved_ = Vertex();
  for (Vertex v : opposite_)
    if (!moved_.valid() && !is_held(c_.held[v]) && rank(c_.mesh, v) == VertexRank::film) moved_ = v;
  if (moved_.valid()) {
    const Vec3& start = c_.mesh.position(moved_);
    const ShapeSummary before = c_.plan.before;
    const Triangle t1 = c_.plan.replaced[0], t2 = c_.plan.replaced[1];
    for (Triangle t : c_.mesh.triangles(moved_)) {
      if (t == t1 || t == t2) continue;
      c_.plan.replaced.push_back(t);
      c_.plan.add_moved(c_.mesh, t, moved_, moved_, start);
    }
    const Vec3 shift = VolumeChange(c_.mesh, c_.plan, moved_).restoring_shift(c_.held[moved_]);
    const double new_length = (c_.mesh.position(opposite_[1]) - c_.mesh.position(opposite_[0])).norm();
    position_ = shift.norm() <= largest_end_shift * new_length ? Vec3(start + shift) : start;
    c_.motion.clear();
    c_.motion.add_planned_star(c_.plan, moved_, position_);
    c_.plan.move(moved_, position_);
    c_.plan.measure(c_.mesh);
    ShapeSummary pair = ShapeSummary::of_none();
    for (std::size_t i = 0; i < 2; ++i) pair.add(c_.plan.triangles[i].corners);
    if (!(pair.min_angle > before.min_angle)) return Refusal::not_better;
  }
  if (const auto refusal = first_broken(shift_invariants, c_.plan, c_.limits)) return refusal;
  if (!c_.guard.flip_is_free(e, opposite_[0], opposite_[1])) return Refusal::intersection;
  const std::array<Vertex, 1> moving = {moved_};
  if (moved_.valid() && !c_.guard.is_free(c_.motion, {moving, e})) return Refusal::intersection;
  return {};
}

std::optional<Refusal> EdgeFlip::check(Edge e) {
  const auto [a, b] = c_.mesh.vertices(e);
  if (is_held(c_.held[a]) && is_held(c_.held[b])) return Refusal::held;
  if (is_in_crease(c_.mesh, a, c_.held[a], b, c_.held[b])) return Refusal::held;
  if (is_border(c_.mesh, e)) return Refusal::junction_topology;
  if (const auto refusal = plan_flip(e)) return refusal;
  return plan_shift(e);
}

std::optional<Refusal> EdgeFlip::attempt(Edge e) {
  if (const auto refusal = check(e)) return refusal;
  FlipEvent event{e, Edge(), c_.mesh.vertices(e), opposite_, moved_, position_, {}};
  c_.notify(&OperationObserver::before_flip, event);
  if (moved_.valid()) c_.mesh.set_position(moved_, position_);
  event.triangles = c_.carry_out();
  added_ = event.added = c_.mesh.find_edge(opposite_[0], opposite_[1]);
  c_.notify(&OperationObserver::after_flip, event);
  return {};
}

}  // namespace lostopos
