#include "tests/support/exact_polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lostopos::test {
namespace {

namespace mp = boost::multiprecision;

Integer shifted(Integer value, unsigned bits) {
  value <<= bits;
  return value;
}

}  // namespace

std::pair<Integer, Integer> alike(const Dyadic& a, const Dyadic& b) {
  const unsigned e = std::max(a.exponent, b.exponent);
  return {shifted(a.numerator, e - a.exponent), shifted(b.numerator, e - b.exponent)};
}

Dyadic Dyadic::of(double x) {
  if (x == 0) return {0, 0};
  const int exponent = std::ilogb(x);
  Integer numerator = static_cast<std::int64_t>(std::scalbn(x, 52 - exponent));
  const unsigned zeros = std::min(mp::lsb(numerator), static_cast<unsigned>(52 - exponent));
  numerator >>= zeros;
  return {std::move(numerator), static_cast<unsigned>(52 - exponent) - zeros};
}

double Dyadic::rounded_down() const {
  if (numerator == 0) return 0;
  constexpr int bits_of_double = 53;
  constexpr int lowest_bit = 1074;
  const int bits = static_cast<int>(mp::msb(numerator)) + 1;
  const int e = static_cast<int>(exponent);
  const int excess = std::max({bits - bits_of_double, e - lowest_bit, 0});
  const Integer leading = numerator >> static_cast<unsigned>(excess);
  return std::ldexp(static_cast<double>(leading.convert_to<std::int64_t>()), excess - e);
}

double Dyadic::rounded_up() const {
  const double below = rounded_down();
  return Dyadic::of(below) < *this ? std::nextafter(below, 1) : below;
}

Dyadic midpoint(const Dyadic& a, const Dyadic& b) {
  const auto [x, y] = alike(a, b);
  return {x + y, std::max(a.exponent, b.exponent) + 1};
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  const auto [x, y] = alike(a, b);
  return {x + y, std::max(a.exponent, b.exponent)};
}

bool operator<(const Dyadic& a, const Dyadic& b) {
  const auto [x, y] = alike(a, b);
  return x < y;
}

Polynomial::Polynomial(Integer constant) : c_{std::move(constant)} {
  trim();
}

Polynomial::Polynomial(Integer constant, Integer slope) : c_{std::move(constant), std::move(slope)} {
  trim();
}

void Polynomial::trim() {
  while (!c_.empty() && c_.back() == 0) c_.pop_back();
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  if (other.c_.size() > c_.size()) c_.resize(other.c_.size());
  for (std::size_t i = 0; i < other.c_.size(); ++i) c_[i] += other.c_[i];
  trim();
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  if (other.c_.size() > c_.size()) c_.resize(other.c_.size());
  for (std::size_t i = 0; i < other.c_.size(); ++i) c_[i] -= other.c_[i];
  trim();
  return *this;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product;
  if (a.is_zero() || b.is_zero()) return product;
  product.c_.resize(a.c_.size() + b.c_.size() - 1);
  for (std::size_t i = 0; i < a.c_.size(); ++i) {
    for (std::size_t j = 0; j < b.c_.size(); ++j) product.c_[i + j] += a.c_[i] * b.c_[j];
  }
  product.trim();
  return product;
}

Polynomial Polynomial::derivative() const {
  Polynomial result;
  for (std::size_t i = 1; i < c_.size(); ++i) result.c_.push_back(c_[i] * static_cast<int>(i));
  return result;
}

Polynomial Polynomial::primitive_part() const {
  Integer content = 0;
  for (const Integer& c : c_) content = mp::gcd(content, c);
  Polynomial result = *this;
  for (Integer& c : result.c_) c /= content;
  return result;
}

int Polynomial::sign_at(const Dyadic& t) const {
  // Horner's scheme for 2^(exponent degree) p(t).
  Integer value = 0;
  unsigned shift = 0;
  for (std::size_t i = c_.size(); i-- > 0; shift += t.exponent) value = value * t.numerator + shifted(c_[i], shift);
  return value.sign();
}

Polynomial::Coefficients Polynomial::bernstein(const Dyadic& low, const Dyadic& high) const {
  // q(s), a positive multiple of p(low + s (high - low)): the variable is 2^e t, then less the lower end (by Horner's
  // scheme), then over the length.
  const auto [start, end] = alike(low, high);
  const unsigned e = std::max(low.exponent, high.exponent);
  const Integer length = end - start;
  const std::size_t n = c_.size() - 1;
  Coefficients q = c_;
  if (e > 0) {
    for (std::size_t i = 0; i < n; ++i) q[i] <<= e * static_cast<unsigned>(n - i);
  }
  if (start != 0) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = n; j-- > i;) q[j] += start * q[j + 1];
    }
  }
  if (length != 1) {
    Integer power = 1;
    for (std::size_t i = 1; i <= n; ++i) q[i] *= power *= length;
  }
  // b_j = sum_i C(j, i) / C(n, i) q_i, times n! to stay with integers.
  static constexpr std::array<int, 8> factorial = {1, 1, 2, 6, 24, 120, 720, 5040};
  Coefficients b(n + 1);
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) b[j] += q[i] * (factorial[j] / factorial[j - i] * factorial[n - i]);
  }
  return b;
}

int sign_changes(const Polynomial::Coefficients& c) {
  int changes = 0;
  int previous = 0;
  for (const Integer& x : c) {
    const int sign = x.sign();
    if (sign * previous < 0) ++changes;
    if (sign != 0) previous = sign;
  }
  return changes;
}

int common_sign(const Polynomial::Coefficients& c) {
  const int sign = c.empty() ? 0 : c.front().sign();
  return std::all_of(c.begin(), c.end(), [sign](const Integer& x) { return x.sign() == sign; }) ? sign : 0;
}

Division::Division(const Polynomial& dividend, const Polynomial& divisor) : remainder(dividend) {
  const Integer& leading = divisor.c_.back();
  const Integer factor = mp::abs(leading);
  while (remainder.degree() >= divisor.degree()) {
    const auto shift = static_cast<std::size_t>(remainder.degree() - divisor.degree());
    Polynomial term;
    term.c_.resize(shift + 1);
    term.c_.back() = leading > 0 ? remainder.c_.back() : Integer(-remainder.c_.back());
    quotient = quotient * Polynomial(factor) + term;
    remainder = remainder * Polynomial(factor) - term * divisor;
  }
}

Polynomial greatest_common_divisor(Polynomial a, Polynomial b) {
  while (!b.is_zero()) {
    Polynomial remainder = Division(a, b).remainder;
    a = std::move(b);
    b = remainder.is_zero() ? remainder : remainder.primitive_part();
  }
  return a.primitive_part();
}

}  // namespace lostopos::test
