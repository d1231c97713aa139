#include "LosTopos/remeshing/null_space_smoothing.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/remeshing/invariants/volume.h"
#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

// After orientation and angles, which most moves fail at.
constexpr std::array other_invariants = {
    Invariant{Refusal::long_edge, keeps_longest_edge},
    Invariant{Refusal::small_area, keeps_min_area},
    Invariant{Refusal::volume_change, keeps_volumes},
};

// To halfway between the neighbours on the border, as far as a step parallel to their chord goes.
Vec3 step_along_border(const SurfaceMesh& mesh, Vertex v) {
  const auto [first, second] = border_edges(mesh, v).first;
  const Vec3 &a = mesh.position(mesh.other_vertex(first, v)), &b = mesh.position(mesh.other_vertex(second, v));
  const Vec3 chord = b - a;
  if (chord.isZero(0)) return Vec3::Zero();
  return (0.5 * (a + b) - mesh.position(v)).dot(chord) / chord.squaredNorm() * chord;
}

// To the centre of the star.
Vec3 step_in_film(const SurfaceMesh& mesh, Vertex v) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (Triangle t : mesh.triangles(v)) {
    sum += area(mesh, t) * barycentre(mesh, t);
    total += area(mesh, t);
  }
  return total > 0 ? Vec3(sum / total - mesh.position(v)) : Vec3::Zero();
}

// d without its components along eigenvectors of `quadric` whose eigenvalues are not small.
Vec3 in_null_space(const Eigen::Matrix3d& quadric, double tolerance, const Vec3& d) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes;
  modes.computeDirect(quadric);
  Vec3 projected = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 mode = modes.eigenvectors().col(i);
    if (modes.eigenvalues()[i] < tolerance * modes.eigenvalues()[2]) projected += mode.dot(d) * mode;
  }
  return projected;
}

// Σ area n nᵀ over the triangles at v.
Eigen::Matrix3d normal_quadric(const SurfaceMesh& mesh, Vertex v) {
  Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
  for (Triangle t : mesh.triangles(v)) {
    const Vec3 normal = area_vector(mesh, t);
    const double size = normal.norm();
    if (size > 0) quadric += normal * normal.transpose() / size;
  }
  return quadric;
}

// The free part of d without its components along the gradients of the regions' volumes in `star`: Gram–Schmidt, for
// full accuracy.
Vec3 keeping_volumes(const SurfaceMesh& mesh, Vertex v, Hold hold, const ChangePlan& star, Vec3 d) {
  // What is left of a gradient after the others (on a border the three sum up to zero) and counts as rounding.
  constexpr double negligible = 1e-6;
  const VolumeChange volumes(mesh, star, v);
  boost::container::static_vector<Vec3, 3> basis;
  for (const auto& r : volumes.regions()) {
    const Vec3 gradient = free_part(hold, r.gradient);
    Vec3 rest = gradient;
    for (const Vec3& direction : basis) rest -= direction.dot(rest) * direction;
    if (basis.size() < 3 && rest.norm() > negligible * gradient.norm()) basis.push_back(rest.normalized());
  }
  d = free_part(hold, d);
  for (const Vec3& direction : basis) d -= direction.dot(d) * direction;
  return d;
}

}  // namespace

void NullSpaceSmoothing::plan_star(Vertex v) {
  ChangePlan& plan = c_.plan;
  plan.clear();
  plan.before = ShapeSummary::of_none();
  for (Triangle t : c_.mesh.triangles(v)) {
    const double smallest = plan.before.min_angle;
    plan.before.add(corners(c_.mesh, t));
    if (plan.before.min_angle < smallest) sharpest_ = plan.replaced.size();
    plan.replaced.push_back(t);
    plan.add_moved(c_.mesh, t, v, v, c_.mesh.position(v));
  }
}

bool NullSpaceSmoothing::improves_smallest_angle() {
  ChangePlan& plan = c_.plan;
  plan.after = ShapeSummary::of_none();
  // The triangle that was sharpest decides mostly, and then no other is looked at.
  for (std::size_t i = 0; i < plan.triangles.size(); ++i) {
    plan.after.add(plan.triangles[(sharpest_ + i) % plan.triangles.size()].corners);
    if (!improves_min_angle(plan, c_.limits)) return false;
  }
  return true;
}

std::optional<Refusal> NullSpaceSmoothing::plan_move(Vertex v, const Vec3& target) {
  c_.plan.move(v, target);
  target_ = target;
  if (!keeps_orientation(c_.plan, c_.limits)) return Refusal::inverted_normal;
  if (!improves_smallest_angle()) return Refusal::not_better;
  c_.plan.measure_volumes(c_.mesh);
  if (const auto refusal = first_broken(other_invariants, c_.plan, c_.limits)) return refusal;
  c_.plan.move(v, c_.mesh.position(v));  // where the motion begins
  c_.motion.clear();
  c_.motion.add_planned_star(c_.plan, v, target);
  c_.plan.move(v, target);
  if (!c_.guard.move_is_free(v, c_.motion)) return Refusal::intersection;
  return {};
}

std::optional<Refusal> NullSpaceSmoothing::refuse(Vertex v, Refusal why) {
  c_.settled.settle(v, why);
  return why;
}

std::optional<Refusal> NullSpaceSmoothing::check(Vertex v) {
  if (is_held(c_.held[v])) return Refusal::held;
  if (const auto known = c_.settled.refusal(v)) return known;
  const VertexRank bound = rank(c_.mesh, v);
  if (bound == VertexRank::corner) return refuse(v, Refusal::junction_topology);
  Vec3 step = bound == VertexRank::border ? step_along_border(c_.mesh, v) : step_in_film(c_.mesh, v);
  step = in_null_space(normal_quadric(c_.mesh, v), c_.options.smoothing_tolerance, step);
  plan_star(v);
  step = keeping_volumes(c_.mesh, v, c_.held[v], c_.plan, step);
  if (step.isZero(0)) return refuse(v, Refusal::not_better);
  bool for_its_star_alone = true;  // other reasons depend on bounds, which change, and on surfaces nearby
  std::optional<Refusal> refusal;
  for (double share : {1.0, 0.5}) {
    refusal = plan_move(v, c_.mesh.position(v) + share * step);
    if (!refusal) return {};
    for_its_star_alone &= refusal == Refusal::not_better || refusal == Refusal::inverted_normal;
  }
  return for_its_star_alone ? refuse(v, *refusal) : refusal;
}

std::optional<Refusal> NullSpaceSmoothing::attempt(Vertex v) {
  if (const auto refusal = check(v)) return refusal;
  const MoveEvent event{v, c_.mesh.position(v), target_};
  c_.notify(&OperationObserver::before_move, event);
  c_.mesh.set_position(v, target_);
  c_.carry_out();
  c_.notify(&OperationObserver::after_move, event);
  return {};
}

}  // namespace lostopos
