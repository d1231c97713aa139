#include "tests/support/ccd_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tests/support/ball.h"

namespace lostopos::test {
namespace {

using BallVector = std::array<Ball, 3>;

template <std::size_t N>
using BallPolynomialVector = std::array<BallPolynomial<N>, 3>;

template <std::size_t N>
BallPolynomialVector<2 * N - 1> cross(const BallPolynomialVector<N>& a, const BallPolynomialVector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <std::size_t M, std::size_t N>
BallPolynomial<M + N - 1> dot(const BallPolynomialVector<M>& a, const BallPolynomialVector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The factor that brings the largest coordinate to about 1, so that products do not overflow.
int scaling_exponent(const std::array<Trajectory, 4>& points) {
  double largest = 0;
  for (const Trajectory& p : points) {
    largest = std::max({largest, p.start.lpNorm<Eigen::Infinity>(), p.end.lpNorm<Eigen::Infinity>()});
  }
  return largest == 0 ? 0 : -std::ilogb(largest);
}

Ball scaled(double x, int exponent) {
  if (exponent == 0) return {x, 0};
  const double y = std::scalbn(x, exponent);
  return {y, std::scalbn(y, -exponent) == x ? 0 : Ball::underflow};
}

// One end of the motion, scaled.
std::array<BallVector, 4> positions(const std::array<Trajectory, 4>& points, Vec3 Trajectory::*end, int exponent) {
  std::array<BallVector, 4> x;
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < 3; ++i) x[k][static_cast<std::size_t>(i)] = scaled((points[k].*end)[i], exponent);
  }
  return x;
}

BallVector operator-(const BallVector& a, const BallVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The vectors that the polynomials are made of, at one time: `count` differences of a vertex of the first shape from
// one of the second, and two edges.
struct Pose {
  double time = 0;
  std::size_t count = 0;
  std::array<BallVector, 6> vectors;
};

Pose vertex_triangle_pose(double time, const std::array<BallVector, 4>& x) {
  return {time, 3, {x[1] - x[0], x[2] - x[0], x[3] - x[0], x[2] - x[1], x[3] - x[1]}};
}

Pose edge_edge_pose(double time, const std::array<BallVector, 4>& x) {
  return {time, 4, {x[2] - x[0], x[3] - x[0], x[2] - x[1], x[3] - x[1], x[1] - x[0], x[3] - x[2]}};
}

// The vectors at one time, as polynomials without and, between two, with a slope.
struct Instant {
  const Pose& pose;

  std::size_t count() const { return pose.count; }

  BallPolynomialVector<1> vector(std::size_t k) const {
    const BallVector& a = pose.vectors[k];
    return {BallPolynomial<1>{{a[0]}}, BallPolynomial<1>{{a[1]}}, BallPolynomial<1>{{a[2]}}};
  }
};

struct Piece {
  const Pose& start;
  const Pose& end;

  std::size_t count() const { return start.count; }

  BallPolynomialVector<2> vector(std::size_t k) const {
    const BallVector& a = start.vectors[k];
    const BallVector& b = end.vectors[k];
    return {BallPolynomial<2>{{a[0], b[0]}}, BallPolynomial<2>{{a[1], b[1]}}, BallPolynomial<2>{{a[2], b[2]}}};
  }
};

template <class Motion>
auto normal_of(const Motion& x) {
  return cross(x.vector(x.count()), x.vector(x.count() + 1));
}

template <class Motion>
auto coplanarity(const Motion& x) {
  return dot(normal_of(x), x.vector(0));
}

template <class Motion>
bool separated_along_an_axis(const Motion& x) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int first = sign(x.vector(0)[axis]);
    bool separated = first != 0;
    for (std::size_t k = 1; k < x.count() && separated; ++k) separated = sign(x.vector(k)[axis]) == first;
    if (separated) return true;
  }
  return false;
}

// 1 when all polynomials are positive that may not be negative at a contact, -1 when one of them is negative.
template <class Motion>
int sign_in_contact(const Motion& x) {
  const auto normal = normal_of(x);
  int lowest = 1;
  if (x.count() == 3) {
    for (std::size_t k = 0; k < 3 && lowest >= 0; ++k) {
      lowest = std::min(lowest, sign(dot(normal, cross(x.vector(k), x.vector((k + 1) % 3)))));
    }
    return lowest;
  }
  const auto whole = dot(normal, normal);
  for (std::size_t k = 4; k < 6 && lowest >= 0; ++k) {
    const auto share = dot(cross(x.vector(0), x.vector(k)), normal);
    lowest = std::min({lowest, sign(share), sign(whole - share)});
  }
  return lowest;
}

// Nothing about this instant alone speaks against a contact, so no piece that it is in can be free of one.
bool may_touch(const Pose& pose) {
  const Instant x{pose};
  return !separated_along_an_axis(x) && sign(coplanarity(x)) == 0 && sign_in_contact(x) >= 0;
}

// The cubic changes its sign once, whatever the members of its balls are, and so has one root, a simple one.
bool has_one_root(const BallPolynomial<4>& cubic) {
  const int first = sign(cubic[0]);
  const int last = sign(cubic[3]);
  return first * last < 0 && (sign(cubic[1]) == first || sign(cubic[2]) == last);
}

// Of a polynomial that changes its sign, in [0, 1]; only a guess.
double approximate_root(const BallPolynomial<4>& p) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {
    const double s = 0.5 * (low + high);
    const double r = 1 - s;
    const double value = ((p[3].value * s + p[2].value * r) * s + p[1].value * r * r) * s + p[0].value * r * r * r;
    ((value > 0) == (p[0].value > 0) ? low : high) = s;
  }
  return 0.5 * (low + high);
}

// How far from the root, in [0, 1], the cubic's rounding errors do not hide its sign any more; only a guess.
double uncertainty(const BallPolynomial<4>& p, double s) {
  const double r = 1 - s;
  const double error = p[0].error + p[1].error + p[2].error + p[3].error;
  const double slope = (p[1].value - 3 * p[0].value) * r * r + 2 * (p[2].value - p[1].value) * s * r +
                       (3 * p[3].value - p[2].value) * s * s;
  return 4 * error / std::abs(slope);
}

enum class Verdict { apart, contact, undecided };

class ContactFilter {
 public:
  ContactFilter(const Pose& start, const Pose& end) : start_(start), end_(end) {}

  FilteredContact first_contact(unsigned bits, std::span<const double> apart_from) {
    if (may_touch(start_) || may_touch(end_)) return {};
    switch (search({start_, end_}, most_halvings)) {
      case Verdict::apart:
        return {true, std::nullopt};
      case Verdict::contact:
        return refine(bits, apart_from) ? FilteredContact{true, found_} : FilteredContact{};
      default:
        return {};
    }
  }

 private:
  static constexpr int most_halvings = 24;

  Verdict search(const Piece& piece, int halvings);
  Verdict search_about_the_root(const Piece& piece, const BallPolynomial<4>& cubic);
  bool cut(double time);
  bool refine(unsigned bits, std::span<const double> apart_from);
  Pose pose(double time) const;

  const Pose& start_;
  const Pose& end_;
  int pieces_left_ = 80;
  ExactContact found_;  // the one root of the cubic in there
  int sign_before_ = 0;
};

Pose ContactFilter::pose(double time) const {
  Pose result{time, start_.count, {}};
  const Ball after{time, 0};
  const Ball before = Ball{1, 0} - after;
  for (std::size_t k = 0; k < start_.count + 2; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.vectors[k][i] = before * start_.vectors[k][i] + after * end_.vectors[k][i];
    }
  }
  return result;
}

Verdict ContactFilter::search(const Piece& piece, int halvings) {
  if (--pieces_left_ < 0) return Verdict::undecided;
  if (separated_along_an_axis(piece)) return Verdict::apart;
  const BallPolynomial<4> cubic = coplanarity(piece);
  if (sign(cubic) != 0) return Verdict::apart;
  if (has_one_root(cubic)) return search_about_the_root(piece, cubic);
  if (sign_in_contact(piece) < 0) return Verdict::apart;
  if (halvings == 0) return Verdict::undecided;
  const Pose middle = pose(0.5 * (piece.start.time + piece.end.time));
  if (may_touch(middle)) return Verdict::undecided;
  const Verdict first = search({piece.start, middle}, halvings - 1);
  return first != Verdict::apart ? first : search({middle, piece.end}, halvings - 1);
}

// There is no other root in the piece than that where the cubic's sign changes.
Verdict ContactFilter::search_about_the_root(const Piece& piece, const BallPolynomial<4>& cubic) {
  const double s = approximate_root(cubic);
  const double length = piece.end.time - piece.start.time;
  const double root = piece.start.time + s * length;
  double reach = uncertainty(cubic, s) * length + 0x1p-50 * root;
  for (int attempt = 0; attempt < 4; ++attempt, reach *= 64) {
    const double low = root - reach;
    const double high = root + reach;
    const Pose before = low > piece.start.time ? pose(low) : piece.start;
    const Pose after = high < piece.end.time ? pose(high) : piece.end;
    const Piece about{before, after};
    const BallPolynomial<4> here = coplanarity(about);
    sign_before_ = sign(here[0]);
    if (sign_before_ * sign(here[3]) >= 0) continue;
    found_ = {before.time, after.time};
    const int containment = sign_in_contact(about);
    return containment > 0 ? Verdict::contact : containment < 0 ? Verdict::apart : Verdict::undecided;
  }
  return Verdict::undecided;
}

// Replaces an end of the interval found by a time in it.
bool ContactFilter::cut(double time) {
  const Pose here = pose(time);
  const int s = sign(coplanarity(Instant{here})[0]);
  if (s != 0) (s == sign_before_ ? found_.low : found_.high) = time;
  return s != 0;
}

bool ContactFilter::refine(unsigned bits, std::span<const double> apart_from) {
  for (const double time : apart_from) {
    if (found_.low < time && time < found_.high && !cut(time)) return false;
  }
  const double longest = std::ldexp(1.0, -static_cast<int>(bits));
  while (found_.high - found_.low > longest) {
    const double middle = 0.5 * (found_.low + found_.high);
    if (middle <= found_.low || middle >= found_.high || !cut(middle)) return false;
  }
  return true;
}

}  // namespace

FilteredContact filter_vertex_triangle(const std::array<Trajectory, 4>& points, unsigned bits,
                                       std::span<const double> apart_from) {
  const int exponent = scaling_exponent(points);
  const Pose start = vertex_triangle_pose(0, positions(points, &Trajectory::start, exponent));
  const Pose end = vertex_triangle_pose(1, positions(points, &Trajectory::end, exponent));
  return ContactFilter(start, end).first_contact(bits, apart_from);
}

FilteredContact filter_edge_edge(const std::array<Trajectory, 4>& points, unsigned bits,
                                 std::span<const double> apart_from) {
  const int exponent = scaling_exponent(points);
  const Pose start = edge_edge_pose(0, positions(points, &Trajectory::start, exponent));
  const Pose end = edge_edge_pose(1, positions(points, &Trajectory::end, exponent));
  return ContactFilter(start, end).first_contact(bits, apart_from);
}

}  // namespace lostopos::test
