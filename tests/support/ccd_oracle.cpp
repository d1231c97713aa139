#include "tests/support/ccd_oracle.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/algebraic_number.h"
#include "tests/support/ccd_filter.h"

namespace lostopos::test {
namespace {

// A vector that is polynomial in time.
using PolynomialVector = std::array<Polynomial, 3>;

PolynomialVector operator-(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_zero_at(const PolynomialVector& v, AlgebraicNumber& t) {
  return std::all_of(v.begin(), v.end(), [&t](const Polynomial& p) { return t.sign_of(p) == 0; });
}

// All coordinates as integers in units of the lowest bit of any of them.
class IntegerMotion {
 public:
  explicit IntegerMotion(const std::array<Trajectory, 4>& points) {
    for (const Trajectory& point : points) {
      for (const Vec3* p : {&point.start, &point.end}) {
        for (int i = 0; i < 3; ++i) note_exponent((*p)[i]);
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      for (int i = 0; i < 3; ++i) {
        Integer start = integer(points[k].start[i]);
        Integer change = integer(points[k].end[i]) - start;
        points_[k][static_cast<std::size_t>(i)] = Polynomial(std::move(start), std::move(change));
      }
    }
  }

  const PolynomialVector& operator[](std::size_t k) const { return points_[k]; }

 private:
  void note_exponent(double x) {
    if (x != 0) lowest_ = std::min(lowest_, std::ilogb(x));
  }

  Integer integer(double x) const {
    if (x == 0) return 0;
    const int exponent = std::ilogb(x);
    Integer value = static_cast<std::int64_t>(std::ldexp(std::scalbn(x, -exponent), 52));
    value <<= static_cast<unsigned>(exponent - lowest_);
    return value;
  }

  int lowest_ = INT_MAX;
  std::array<PolynomialVector, 4> points_;
};

// Two vectors from the origin; they hold the origin between them when they point in opposite directions.
using Pair = std::pair<const PolynomialVector*, const PolynomialVector*>;

bool holds_origin(const Pair& pair, AlgebraicNumber& t) {
  return t.sign_of(dot(*pair.first, *pair.second)) <= 0 && is_zero_at(cross(*pair.first, *pair.second), t);
}

// What the two queries have in common; `differences` is the hull that contains the origin at a contact.
struct Query {
  std::vector<PolynomialVector> differences;
  std::vector<std::pair<std::size_t, std::size_t>> boundary;  // segments of differences where a contact can begin
  PolynomialVector e1;
  PolynomialVector e2;

  Pair pair(const std::pair<std::size_t, std::size_t>& b) const {
    return {&differences[b.first], &differences[b.second]};
  }

  bool on_boundary(AlgebraicNumber& t) const {
    return std::any_of(boundary.begin(), boundary.end(), [&](const auto& b) { return holds_origin(pair(b), t); });
  }
};

bool triangle_holds_origin(const Query& q, const PolynomialVector& normal, AlgebraicNumber& t) {
  return std::all_of(q.boundary.begin(), q.boundary.end(), [&](const auto& b) {
    return t.sign_of(dot(normal, cross(q.differences[b.first], q.differences[b.second]))) >= 0;
  });
}

bool edges_meet(const Query& q, const PolynomialVector& normal, AlgebraicNumber& t) {
  const Polynomial whole = dot(normal, normal);
  for (const PolynomialVector* e : {&q.e1, &q.e2}) {
    const Polynomial share = dot(cross(q.differences[0], *e), normal);
    if (t.sign_of(share) < 0 || t.sign_of(whole - share) < 0) return false;
  }
  return true;
}

// The shapes are coplanar at t.
bool in_contact(const Query& q, const PolynomialVector& normal, AlgebraicNumber& t) {
  if (is_zero_at(normal, t)) return q.on_boundary(t);
  return q.differences.size() == 3 ? triangle_holds_origin(q, normal, t) : edges_meet(q, normal, t);
}

bool separated_along_an_axis(const Query& q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool positive = true;
    bool negative = true;
    for (const PolynomialVector& d : q.differences) {
      const int start = d[axis].sign_at({0, 0});
      const int end = d[axis].sign_at({1, 0});
      positive = positive && start > 0 && end > 0;
      negative = negative && start < 0 && end < 0;
    }
    if (positive || negative) return true;
  }
  return false;
}

// Coplanar at all times, not in contact at the start: a contact begins when a vertex comes to lie on an edge, or on a
// vertex if it is always on the edge's line.
std::vector<AlgebraicNumber> times_in_one_plane(const Query& q) {
  std::vector<AlgebraicNumber> times;
  const auto append_roots = [&times](const PolynomialVector& v) {
    const auto moving = std::find_if(v.begin(), v.end(), [](const Polynomial& p) { return !p.is_zero(); });
    if (moving == v.end()) return false;
    for (AlgebraicNumber& root : roots_in_unit_interval(*moving)) times.push_back(std::move(root));
    return true;
  };
  for (const auto& [i, j] : q.boundary) {
    if (append_roots(cross(q.differences[i], q.differences[j]))) continue;
    append_roots(q.differences[i]);
    append_roots(q.differences[j]);
  }
  times.emplace_back(Dyadic{1, 0});
  return times;
}

ExactContact refined(AlgebraicNumber& t, const OracleOptions& options) {
  for (const double time : options.apart_from) t.cut(Dyadic::of(time));
  t.refine(options.bits);
  return {t.low().rounded_down(), t.high().rounded_up()};
}

std::optional<ExactContact> first_contact(const Query& q, const OracleOptions& options) {
  if (separated_along_an_axis(q)) return std::nullopt;
  const PolynomialVector normal = cross(q.e1, q.e2);
  const Polynomial coplanarity = dot(normal, q.differences[0]);
  AlgebraicNumber start(Dyadic{0, 0});
  if (start.sign_of(coplanarity) == 0 && in_contact(q, normal, start)) return ExactContact{0, 0};
  if (coplanarity.is_zero()) {
    std::optional<ExactContact> first;
    for (AlgebraicNumber& t : times_in_one_plane(q)) {
      if (!in_contact(q, normal, t)) continue;
      const ExactContact contact = refined(t, options);
      if (!first) first = contact;
      first = ExactContact{std::min(first->low, contact.low), std::min(first->high, contact.high)};
    }
    return first;
  }
  for (AlgebraicNumber& t : roots_in_unit_interval(coplanarity)) {
    if (in_contact(q, normal, t)) return refined(t, options);
  }
  AlgebraicNumber end(Dyadic{1, 0});
  if (end.sign_of(coplanarity) == 0 && in_contact(q, normal, end)) return ExactContact{1, 1};
  return std::nullopt;
}

}  // namespace

std::optional<ExactContact> exact_vertex_triangle(const std::array<Trajectory, 4>& points,
                                                  const OracleOptions& options) {
  if (options.filter) {
    const FilteredContact filtered = filter_vertex_triangle(points, options.bits, options.apart_from);
    if (filtered.decided) return filtered.contact;
  }
  const IntegerMotion x(points);
  Query q;
  q.differences = {x[1] - x[0], x[2] - x[0], x[3] - x[0]};
  q.boundary = {{0, 1}, {1, 2}, {2, 0}};
  q.e1 = x[2] - x[1];
  q.e2 = x[3] - x[1];
  return first_contact(q, options);
}

std::optional<ExactContact> exact_edge_edge(const std::array<Trajectory, 4>& points, const OracleOptions& options) {
  if (options.filter) {
    const FilteredContact filtered = filter_edge_edge(points, options.bits, options.apart_from);
    if (filtered.decided) return filtered.contact;
  }
  const IntegerMotion x(points);
  Query q;
  q.differences = {x[2] - x[0], x[3] - x[0], x[2] - x[1], x[3] - x[1]};
  q.boundary = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
  q.e1 = x[1] - x[0];
  q.e2 = x[3] - x[2];
  return first_contact(q, options);
}

}  // namespace lostopos::test
