#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lostopos::test {

/// All real numbers no farther than `error` from `value`: ball arithmetic (van der Hoeven 2010, "Ball arithmetic") in
/// double precision. An operation's ball holds the exact results for all members of its operands' balls. Rounding to
/// nearest is off by at most 2^-53 of the rounded result, and by less than `underflow` below the range of doubles. A
/// ball that has overflowed has no sign, so that nothing is concluded from it.
struct Ball {
  double value = 0;
  double error = 0;

  static constexpr double underflow = 0x1p-1000;

  /// The ball of an operation that was rounded to `value` and has passed on `error` from its operands.
  static Ball rounded(double value, double error) {
    constexpr double unit = 0x1p-53;
    constexpr double grow = 1 + 0x1p-49;  // for the roundings of up to eight operations on errors
    return {value, (error + unit * std::abs(value)) * grow + underflow};
  }

  friend Ball operator+(const Ball& a, const Ball& b) { return rounded(a.value + b.value, a.error + b.error); }
  friend Ball operator-(const Ball& a, const Ball& b) { return rounded(a.value - b.value, a.error + b.error); }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return rounded(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
  }
};

/// 1 or -1 when all members have that strict sign, else 0.
inline int sign(const Ball& a) {
  return a.value > a.error ? 1 : -a.value > a.error ? -1 : 0;
}

/// A polynomial of degree N - 1: the sum of c[k] s^k (1 - s)^(N - 1 - k), for s in [0, 1]. The coefficients have the
/// signs of those in Bernstein's form, which are c[k] over binomials, and the product is a plain convolution.
template <std::size_t N>
struct BallPolynomial {
  std::array<Ball, N> c;

  const Ball& operator[](std::size_t k) const { return c[k]; }

  friend BallPolynomial operator+(BallPolynomial a, const BallPolynomial& b) {
    for (std::size_t k = 0; k < N; ++k) a.c[k] = a.c[k] + b.c[k];
    return a;
  }

  friend BallPolynomial operator-(BallPolynomial a, const BallPolynomial& b) {
    for (std::size_t k = 0; k < N; ++k) a.c[k] = a.c[k] - b.c[k];
    return a;
  }

  template <std::size_t M>
  friend BallPolynomial<N + M - 1> operator*(const BallPolynomial& a, const BallPolynomial<M>& b) {
    BallPolynomial<N + M - 1> product;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < M; ++j) product.c[i + j] = product.c[i + j] + a.c[i] * b.c[j];
    }
    return product;
  }
};

/// The common strict sign of all coefficients, which the polynomial then has on [0, 1], or 0 when they have none.
template <std::size_t N>
int sign(const BallPolynomial<N>& p) {
  const int first = sign(p[0]);
  for (std::size_t k = 1; k < N; ++k) {
    if (sign(p[k]) != first) return 0;
  }
  return first;
}

}  // namespace lostopos::test
