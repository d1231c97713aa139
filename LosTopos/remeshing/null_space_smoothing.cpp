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

constexpr std::array smoothing_invariants = {
    Invariant{Refusal::inverted_normal, keeps_orientation}, Invariant{Refusal::not_better, improves_min_angle},
    Invariant{Refusal::long_edge, keeps_longest_edge},      Invariant{Refusal::small_area, keeps_min_area},
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

// The free part of d without its components along the gradients of the regions' volumes: Gram–Schmidt, for full
// accuracy.
Vec3 keeping_volumes(const SurfaceMesh& mesh, Vertex v, Hold hold, ChangePlan& plan, Vec3 d) {
  // What is left of a gradient after the others (on a border the three sum up to zero) and counts as rounding.
  constexpr double negligible = 1e-6;
  plan.clear();
  for (Triangle t : mesh.triangles(v)) plan.add_moved(mesh, t, v, v, mesh.position(v));
  const VolumeChange volumes(mesh, plan, v);
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

std::optional<Refusal> NullSpaceSmoothing::plan_move(Vertex v, const Vec3& target) {
  c_.plan.clear();
  for (Triangle t : c_.mesh.triangles(v)) {
    c_.plan.replaced.push_back(t);
    c_.plan.add_moved(c_.mesh, t, v, v, c_.mesh.position(v));
  }
  c_.motion.clear();
  c_.motion.add_planned_star(c_.plan, v, target);
  c_.plan.move(v, target);
  c_.plan.measure(c_.mesh);
  target_ = target;
  if (const auto refusal = first_broken(smoothing_invariants, c_.plan, c_.limits)) return refusal;
  if (!c_.guard.move_is_free(v, c_.motion)) return Refusal::intersection;
  return {};
}

std::optional<Refusal> NullSpaceSmoothing::check(Vertex v) {
  if (is_held(c_.held[v])) return Refusal::held;
  const VertexRank bound = rank(c_.mesh, v);
  if (bound == VertexRank::corner) return Refusal::junction_topology;
  Vec3 step = bound == VertexRank::border ? step_along_border(c_.mesh, v) : step_in_film(c_.mesh, v);
  step = in_null_space(normal_quadric(c_.mesh, v), c_.options.smoothing_tolerance, step);
  step = keeping_volumes(c_.mesh, v, c_.held[v], c_.plan, step);
  if (step.isZero(0)) return Refusal::not_better;
  std::optional<Refusal> refusal;
  for (double share : {1.0, 0.5}) {
    refusal = plan_move(v, c_.mesh.position(v) + share * step);
    if (!refusal) break;
  }
  return refusal;
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
