#include "tests/LosTopos/geometry/ccd_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <sstream>
#include <vector>

#include "Base/parallel/for_each.h"
#include "LosTopos/geometry/distance.h"

namespace lostopos::test {
namespace {

std::string text_of(const Query& query) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Trajectory& p : query) out << p.start.transpose() << " -> " << p.end.transpose() << '\n';
  return out.str();
}

// The orders of the arguments that mean the same query: 6 of a triangle, 8 of two edges.
std::array<std::size_t, 4> equivalent_order(Shape shape, int which) {
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  if (shape == Shape::vertex_triangle) {
    for (int i = 0; i < which % 6; ++i) std::next_permutation(order.begin() + 1, order.end());
    return order;
  }
  if ((which & 1) != 0) std::swap(order[0], order[1]);
  if ((which & 2) != 0) std::swap(order[2], order[3]);
  if ((which & 4) != 0) std::rotate(order.begin(), order.begin() + 2, order.end());
  return order;
}

// Bitwise the same, but for weights of points that move alike and may be taken for each other.
bool same_answer(const std::optional<Collision>& a, const std::optional<Collision>& b, bool edges_swapped) {
  if (!a || !b) return !a && !b;
  const Vec3 normal = edges_swapped ? Vec3(-b->normal) : b->normal;
  return a->time == b->time && a->relative_displacement == b->relative_displacement && a->normal == normal;
}

bool same_weights(const Collision& a, const Collision& b, const std::array<std::size_t, 4>& order, const Query& query) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (query[i].start == query[j].start && query[i].end == query[j].end) return true;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (b.weights[i] != a.weights[order[i]]) return false;
  }
  return true;
}

bool order_matters(Shape shape, const Query& query, const std::optional<Collision>& answer, int which) {
  const std::array<std::size_t, 4> order = equivalent_order(shape, which);
  const Query other = {query[order[0]], query[order[1]], query[order[2]], query[order[3]]};
  const std::optional<Collision> other_answer = collide(shape, other);
  const bool edges_swapped = shape == Shape::edge_edge && order[0] > 1;
  if (!same_answer(answer, other_answer, edges_swapped)) {
    // Edges that move alike may be taken for each other: the normal's sign is not defined then.
    return !edges_swapped || !same_answer(answer, other_answer, false) || answer->relative_displacement != 0;
  }
  return answer && !same_weights(*answer, *other_answer, order, query);
}

bool well_formed(Shape shape, const Collision& c) {
  const auto& w = c.weights;
  const double first = shape == Shape::edge_edge ? w[0] + w[1] : w[0];
  const double second = shape == Shape::edge_edge ? w[2] + w[3] : w[1] + w[2] + w[3];
  return c.time >= 0 && c.time <= 1 && *std::min_element(w.begin(), w.end()) >= 0 && std::abs(first - 1) < 1e-15 &&
         std::abs(second - 1) < 1e-15 && std::abs(c.normal.norm() - 1) < 1e-14 && std::isfinite(c.normal.sum());
}

// Distance of the shapes at the time over the largest difference of coordinates, for any scale.
double relative_gap(Shape shape, const Query& q, double time) {
  double largest = 0;
  for (const Trajectory& p : q) {
    largest = std::max({largest, p.start.lpNorm<Eigen::Infinity>(), p.end.lpNorm<Eigen::Infinity>()});
  }
  const double guard = largest > 1 ? 0.25 : 1;  // against overflow of differences
  double size = 0;
  double scale = 1;
  const auto difference = [&](std::size_t i, std::size_t j) {
    const Vec3 start = guard * q[i].start - guard * q[j].start;
    const Vec3 end = guard * q[i].end - guard * q[j].end;
    size = std::max({size, start.lpNorm<Eigen::Infinity>(), end.lpNorm<Eigen::Infinity>()});
    return Vec3((1 - time) * (scale * start) + time * (scale * end));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) difference(i, j);
  }
  if (size == 0) return 0;
  scale = std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000));
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = difference(i, 0);
  const double distance = shape == Shape::vertex_triangle ? point_triangle_distance(x[0], x[1], x[2], x[3]).distance
                                                          : segment_segment_distance(x[0], x[1], x[2], x[3]).distance;
  return distance / (scale * size);
}

void compare(Shape shape, const Query& query, const std::optional<Collision>& answer, CheckResult& result) {
  constexpr double much_too_early = 1e-6;
  const double time = answer ? answer->time : 0;
  const std::array<double, 2> apart_from = {time, std::min(time + much_too_early, 1.0)};
  const auto exact = exact_contact(shape, query, {.apart_from = apart_from});
  if (exact) ++result.exact_hits;
  if (exact && !answer) ++result.missed;
  if (!answer) return;
  if (!exact) ++result.false_hits;
  if (exact && exact->is_before(apart_from[0])) ++result.late;
  if (exact && exact->is_after(apart_from[1])) ++result.early;
  if (!well_formed(shape, *answer)) ++result.malformed;
  result.largest_gap = std::max(result.largest_gap, relative_gap(shape, query, answer->time));
}

void print(Shape shape, bool adversarial, const CheckResult& r) {
  std::printf(
      "%s, %s: %ld queries, %ld exact hits, %ld missed, %ld false hits (%.4f %%), %ld late, %ld order-dependent, "
      "%ld early by over 1e-6, largest relative gap at a hit %.2g\n",
      shape == Shape::vertex_triangle ? "vertex-triangle" : "edge-edge", adversarial ? "adversarial" : "random",
      r.queries, r.exact_hits, r.missed, r.false_hits, 100 * r.false_hit_rate(), r.late, r.order_dependent, r.early,
      r.largest_gap);
}

// Queries that share a generator.
constexpr long queries_of_a_part = 1L << 15U;

CheckResult check_part(Shape shape, bool adversarial, long count, std::uint64_t seed) {
  QueryGenerator generator(seed);
  CheckResult result;
  for (long i = 0; i < count; ++i) {
    const Query query = adversarial ? generator.adversarial(shape) : generator.random();
    const std::optional<Collision> answer = collide(shape, query);
    ++result.queries;
    compare(shape, query, answer, result);
    if (order_matters(shape, query, answer, 1 + static_cast<int>(i % 7))) ++result.order_dependent;
    const long failures = result.missed + result.late + result.order_dependent + result.malformed;
    if (failures > 0 && result.first_failure.empty()) result.first_failure = text_of(query);
  }
  return result;
}

void add(const CheckResult& some, CheckResult& all) {
  all.queries += some.queries;
  all.exact_hits += some.exact_hits;
  all.missed += some.missed;
  all.false_hits += some.false_hits;
  all.late += some.late;
  all.order_dependent += some.order_dependent;
  all.malformed += some.malformed;
  all.early += some.early;
  all.largest_gap = std::max(all.largest_gap, some.largest_gap);
  if (all.first_failure.empty()) all.first_failure = some.first_failure;
}

}  // namespace

CheckResult check_against_oracle(Shape shape, bool adversarial, long count, std::uint64_t seed, long from) {
  const long first = from / queries_of_a_part;
  std::vector<CheckResult> parts(static_cast<std::size_t>((count + queries_of_a_part - 1) / queries_of_a_part));
  base::parallel_for_each(parts.size(), 1, [&](std::size_t i) {
    constexpr std::uint64_t apart = 1000;  // seeds of sets are smaller
    const long place = static_cast<long>(i);
    const long queries = std::min(queries_of_a_part, count - place * queries_of_a_part);
    parts[i] = check_part(shape, adversarial, queries, seed + apart * static_cast<std::uint64_t>(first + place));
  });
  CheckResult result;
  for (const CheckResult& some : parts) add(some, result);
  print(shape, adversarial, result);
  return result;
}

}  // namespace lostopos::test
