#include "tests/support/algebraic_number.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lostopos::test {
namespace {

namespace mp = boost::multiprecision;

using Coefficients = Polynomial::Coefficients;

// Finds the roots by Descartes' rule of signs on Bernstein coefficients, in halves where it leaves more than one open
// (Collins and Akritas 1976; Lane and Riesenfeld 1981).
class RootIsolation {
 public:
  explicit RootIsolation(const Polynomial& p) : p_(std::make_shared<const Polynomial>(p)) {}

  std::vector<AlgebraicNumber> roots() {
    if (!isolate_all()) {
      // Perhaps a multiple root, which no halving would end at.
      const Polynomial repeated = greatest_common_divisor(*p_, p_->derivative());
      const Polynomial simple = repeated.degree() > 0 ? Division(*p_, repeated).quotient : *p_;
      p_ = std::make_shared<const Polynomial>(simple.primitive_part());
      square_free_ = true;
      isolate_all();
    }
    return std::move(roots_);
  }

 private:
  bool isolate_all() {
    roots_.clear();
    return isolate(p_->bernstein({0, 0}, {1, 0}), 0, 0);
  }

  // The roots in (k / 2^e, (k + 1) / 2^e), of which b are the Bernstein coefficients.
  bool isolate(const Coefficients& b, const Integer& k, unsigned e) {
    const int changes = sign_changes(b);
    if (changes == 0) return true;
    if (changes == 1) {
      const auto first = std::find_if(b.begin(), b.end(), [](const Integer& x) { return x != 0; });
      roots_.emplace_back(p_, first->sign(), Dyadic{k, e}, Dyadic{k + 1, e});
      return true;
    }
    constexpr unsigned most_halvings = 6;
    if (!square_free_ && e == most_halvings) return false;
    Coefficients left = b;
    const Coefficients right = halve(left);
    const Integer middle = 2 * k + 1;
    if (!isolate(left, middle - 1, e + 1)) return false;
    if (right.front() == 0) roots_.emplace_back(Dyadic{middle, e + 1});
    return isolate(right, middle, e + 1);
  }

  // De Casteljau's algorithm without its divisions: leaves 2^n times the coefficients of the left half, and gives those
  // of the right half.
  static Coefficients halve(Coefficients& left) {
    const std::size_t n = left.size() - 1;
    Coefficients right(n + 1);
    Coefficients sums = left;
    for (std::size_t r = 0; r <= n; ++r) {
      const auto missing = static_cast<unsigned>(n - r);
      left[r] = sums[0] << missing;
      right[n - r] = sums[n - r] << missing;
      for (std::size_t i = 0; i + r < n; ++i) sums[i] += sums[i + 1];
    }
    return right;
  }

  std::shared_ptr<const Polynomial> p_;
  bool square_free_ = false;
  std::vector<AlgebraicNumber> roots_;
};

// Where in [0, 1] the root is, to what double precision can tell.
double approximate_root(const Coefficients& bernstein, int sign_below) {
  constexpr unsigned bits_of_double = 1000;
  unsigned bits = 0;
  for (const Integer& b : bernstein) bits = std::max(bits, b == 0 ? 0 : mp::msb(mp::abs(b)));
  boost::container::static_vector<double, 8> c;
  for (const Integer& b : bernstein) {
    c.push_back((bits > bits_of_double ? Integer(b >> (bits - bits_of_double)) : b).convert_to<double>());
  }
  double low = 0;
  double high = 1;
  for (int step = 0; step < 45; ++step) {
    const double s = 0.5 * (low + high);
    auto d = c;  // de Casteljau's algorithm
    for (std::size_t n = d.size() - 1; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i) d[i] += s * (d[i + 1] - d[i]);
    }
    ((d[0] > 0) == (sign_below > 0) ? low : high) = s;
  }
  return low;
}

}  // namespace

bool AlgebraicNumber::cut(const Dyadic& t) {
  if (!polynomial_ || !(low_ < t) || !(t < high_)) return false;
  const int sign = polynomial_->sign_at(t);
  if (sign == 0) {
    low_ = high_ = t;
    polynomial_.reset();
  } else {
    (sign == sign_below_ ? low_ : high_) = t;
  }
  return true;
}

void AlgebraicNumber::refine(unsigned bits) {
  const Dyadic longest{1, bits};
  while (polynomial_ && low_ + longest < high_) approach();
}

// Makes the interval 2^-40 times as long when double precision sees where in it the root is, else half as long.
void AlgebraicNumber::approach() {
  constexpr unsigned bits = 42;
  const double s = approximate_root(polynomial_->bernstein(low_, high_), sign_below_);
  const auto cell = static_cast<std::int64_t>(std::ldexp(s, bits));
  const auto [low, high] = alike(low_, high_);
  const unsigned exponent = std::max(low_.exponent, high_.exponent) + bits;
  const Integer start = low << bits;
  const Integer length = high - low;
  const bool below = cut({start + length * (cell - 1), exponent});
  const bool above = cut({start + length * (cell + 2), exponent});
  if (!below || !above) cut(midpoint(low_, high_));
}

int AlgebraicNumber::sign_of(const Polynomial& p) {
  if (p.is_zero()) return 0;
  constexpr int cheap_attempts = 2;
  for (int attempt = 0; polynomial_; ++attempt) {
    const int sign = common_sign(p.bernstein(low_, high_));
    if (sign != 0) return sign;
    if (attempt == cheap_attempts) {
      // A common factor has this number as its root, a simple one, or none in the interval.
      const Polynomial common = greatest_common_divisor(p, *polynomial_);
      if (common.degree() > 0 && sign_changes(common.bernstein(low_, high_)) % 2 != 0) return 0;
    }
    approach();
  }
  return p.sign_at(low_);
}

std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& p) {
  return p.degree() < 1 ? std::vector<AlgebraicNumber>() : RootIsolation(p).roots();
}

}  // namespace lostopos::test
