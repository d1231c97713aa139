#include "LosTopos/remeshing/remesh_pass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "Base/lists/erase_repeated.h"
#include "Base/timing/stopwatch.h"
#include "LosTopos/geometry/triangle_quality.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

/// Whether the angle between u and v is less than one with this cosine, without a root or a division.
bool is_sharper(const Vec3& u, const Vec3& v, double cosine) {
  const double dot = u.dot(v), bound = cosine * std::abs(cosine) * u.squaredNorm() * v.squaredNorm();
  return dot * std::abs(dot) > bound;
}

/// The cosines of the bounds for a triangle's angles.
struct AngleTest {
  double cosine_of_smallest, cosine_of_largest;

  bool has_small(const Corners& x) const {
    return is_sharper(x[1] - x[0], x[2] - x[0], cosine_of_smallest) ||
           is_sharper(x[2] - x[1], x[0] - x[1], cosine_of_smallest) ||
           is_sharper(x[0] - x[2], x[1] - x[2], cosine_of_smallest);
  }
  bool has_large(const Corners& x) const {
    return !is_sharper(x[1] - x[0], x[2] - x[0], cosine_of_largest) ||
           !is_sharper(x[2] - x[1], x[0] - x[1], cosine_of_largest) ||
           !is_sharper(x[0] - x[2], x[1] - x[2], cosine_of_largest);
  }
};

// The edge of t opposite to its largest angle.
Edge longest_edge(const SurfaceMesh& mesh, Triangle t) {
  return *std::ranges::max_element(mesh.edges(t), {}, [&mesh](Edge e) { return length(mesh, e); });
}

Edge shortest_edge(const SurfaceMesh& mesh, Triangle t) {
  return *std::ranges::min_element(mesh.edges(t), {}, [&mesh](Edge e) { return length(mesh, e); });
}

}  // namespace

RemeshPass::RemeshPass(RemeshContext& context, RemeshStatistics& statistics)
    : c_(context),
      statistics_(statistics),
      split_(context),
      collapse_(context),
      flip_(context),
      smoothing_(context),
      shortest_(context.limits.shortest_edge),
      longest_(context.limits.longest_edge) {}

double RemeshPass::squared_length(Edge e) const {
  const auto [a, b] = c_.mesh.vertices(e);
  return (c_.mesh.position(b) - c_.mesh.position(a)).squaredNorm();
}

void RemeshPass::require_room() const {
  const std::size_t most = c_.options.most_triangles;
  if (most == 0 || c_.mesh.triangle_count() < most) return;
  std::ostringstream message;
  message << "remeshing to edges of " << c_.options.target_edge << " has come to " << c_.mesh.triangle_count()
          << " triangles, as many as memory_limit has room for; a coarser resolution would need less";
  throw base::Error(message.str());
}

bool RemeshPass::try_split(Edge e) {
  if (!c_.options.split) return false;
  c_.options.interruption.check();
  require_room();
  const auto refusal = split_.attempt(e);
  statistics_[Operation::split].count(refusal);
  return !refusal;
}

bool RemeshPass::try_collapse(Edge e) {
  if (!c_.options.collapse) return false;
  c_.options.interruption.check();
  const auto refusal = collapse_.attempt(e);
  statistics_[Operation::collapse].count(refusal);
  return !refusal;
}

bool RemeshPass::try_flip(Edge e) {
  if (!c_.options.flip) return false;
  c_.options.interruption.check();
  const auto refusal = flip_.attempt(e);
  statistics_[Operation::flip].count(refusal);
  return !refusal;
}

void RemeshPass::split_long_edges() {
  const base::TimedScope timed(statistics_[Operation::split].seconds);
  tasks_.clear();
  for (Edge e : c_.mesh.edges())
    if (too_long(e)) tasks_.push_back({-squared_length(e), e});
  for (int sweep = 0; sweep < c_.options.max_sweeps && !tasks_.empty(); ++sweep) {
    base::sort_unique(tasks_);
    next_tasks_.clear();
    for (const auto& [key, e] : tasks_) {
      // A slot may hold another edge by now: that one is listed by itself.
      if (!c_.mesh.alive(e) || -squared_length(e) != key || !try_split(e)) continue;
      for (Edge f : c_.mesh.edges(split_.added()))
        if (too_long(f)) next_tasks_.push_back({-squared_length(f), f});
    }
    tasks_.swap(next_tasks_);
  }
}

void RemeshPass::split_large_angles() {
  const base::TimedScope timed(statistics_[Operation::split].seconds);
  const AngleTest test{1, std::cos(c_.limits.split_angle)};
  Tasks<Triangle> list;
  for (Triangle t : c_.mesh.triangles()) {
    const Corners x = corners(c_.mesh, t);
    if (test.has_large(x)) list.push_back({-max_angle(x[0], x[1], x[2]), t});
  }
  std::sort(list.begin(), list.end());
  // One sweep: a split halves the angle, so it makes none that is too large beside the edge.
  for (const auto& [key, t] : list) {
    if (!c_.mesh.alive(t) || !test.has_large(corners(c_.mesh, t))) continue;
    try_split(longest_edge(c_.mesh, t));
  }
}

void RemeshPass::collapse_short_edges() {
  const base::TimedScope timed(statistics_[Operation::collapse].seconds);
  tasks_.clear();
  for (Edge e : c_.mesh.edges())
    if (too_short(e)) tasks_.push_back({squared_length(e), e});
  for (int sweep = 0; sweep < c_.options.max_sweeps && !tasks_.empty(); ++sweep) {
    base::sort_unique(tasks_);
    next_tasks_.clear();
    for (const auto& [key, e] : tasks_) {
      if (!c_.mesh.alive(e) || !too_short(e) || !try_collapse(e)) continue;
      for (Edge f : c_.mesh.edges(collapse_.kept()))
        if (too_short(f)) next_tasks_.push_back({squared_length(f), f});
    }
    tasks_.swap(next_tasks_);
  }
}

void RemeshPass::list_flips_near(std::span<const Vertex> vertices, Tasks<Edge>& list) const {
  for (Vertex v : vertices)
    for (Edge e : c_.mesh.edges(v))
      if (EdgeFlip::is_wanted(c_.mesh, e)) list.push_back({0, e});
}

void RemeshPass::flip_edges() {
  const base::TimedScope timed(statistics_[Operation::flip].seconds);
  tasks_.clear();
  for (Edge e : c_.mesh.edges())
    if (EdgeFlip::is_wanted(c_.mesh, e)) tasks_.push_back({0, e});
  for (int sweep = 0; sweep < c_.options.max_sweeps && !tasks_.empty(); ++sweep) {
    base::sort_unique(tasks_);
    next_tasks_.clear();
    for (const auto& [key, e] : tasks_) {
      if (!c_.mesh.alive(e) || !EdgeFlip::is_wanted(c_.mesh, e)) continue;
      const std::array<Vertex, 2> ends = c_.mesh.vertices(e);
      if (!try_flip(e)) continue;
      list_flips_near(ends, next_tasks_);
      list_flips_near(c_.mesh.vertices(flip_.added()), next_tasks_);
    }
    tasks_.swap(next_tasks_);
  }
}

void RemeshPass::smooth() {
  const base::TimedScope timed(statistics_[Operation::smoothing].seconds);
  const AngleTest test{std::cos(c_.options.smooth_below_angle * std::numbers::pi / 180), -1};
  std::vector<Vertex> list;
  for (Triangle t : c_.mesh.triangles())
    if (test.has_small(corners(c_.mesh, t)))
      list.insert(list.end(), c_.mesh.vertices(t).begin(), c_.mesh.vertices(t).end());
  base::sort_unique(list);
  for (Vertex v : list) {
    c_.options.interruption.check();
    statistics_[Operation::smoothing].count(smoothing_.attempt(v));
  }
}

bool RemeshPass::is_bad(Triangle t) const {
  const auto [a, b, c] = corners(c_.mesh, t);
  const double min_area = c_.options.min_area * c_.options.target_edge * c_.options.target_edge;
  const double twice_area_squared = (b - a).cross(c - a).squaredNorm();
  if (!(twice_area_squared >= 4 * min_area * min_area)) return true;
  const AngleTest test{std::cos(c_.limits.min_angle), std::cos(c_.limits.max_angle)};
  return test.has_small({a, b, c}) || test.has_large({a, b, c});
}

bool RemeshPass::has_bad_triangles() const {
  return std::ranges::any_of(c_.mesh.triangles(), [this](Triangle t) { return is_bad(t); });
}

void RemeshPass::mend(Triangle t) {
  const auto [a, b, c] = corners(c_.mesh, t);
  const std::array<Vertex, 3> vertices = c_.mesh.vertices(t);
  const Edge longest = longest_edge(c_.mesh, t);
  const bool is_cap = max_angle(a, b, c) > 0.75 * std::numbers::pi;
  // A cap (one large angle) has no short edge; a needle has.
  const bool done = is_cap ? try_flip(longest) || try_split(longest) || try_collapse(shortest_edge(c_.mesh, t))
                           : try_collapse(shortest_edge(c_.mesh, t)) || try_flip(longest);
  if (!done || !c_.options.smoothing) return;
  for (Vertex v : vertices)
    if (c_.mesh.alive(v)) statistics_[Operation::smoothing].count(smoothing_.attempt(v));
}

void RemeshPass::mend_bad_triangles() {
  const Limits strict = c_.limits;
  c_.limits = relaxed(strict);
  Tasks<Triangle> list;
  for (Triangle t : c_.mesh.triangles()) {
    const auto [a, b, c] = corners(c_.mesh, t);
    if (is_bad(t)) list.push_back({min_angle(a, b, c), t});
  }
  std::sort(list.begin(), list.end());
  for (const auto& [key, t] : list)
    if (c_.mesh.alive(t) && is_bad(t)) mend(t);
  c_.limits = strict;
}

void RemeshPass::count_what_is_left() {
  auto count = [](EdgesLeft& left, std::optional<Refusal> refusal) {
    ++(refusal ? left.refused[static_cast<std::size_t>(*refusal)] : left.sweeps_used_up);
  };
  for (Edge e : c_.mesh.edges()) {
    if (too_long(e)) count(statistics_.too_long, split_.check(e));
    if (too_short(e)) count(statistics_.too_short, collapse_.check(e));
  }
  for (Triangle t : c_.mesh.triangles())
    if (is_bad(t)) ++statistics_.triangles_out_of_bounds;
}

}  // namespace lostopos
