#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <vector>

namespace lostopos::test {

// Integer polynomials and their real roots in exact arithmetic, for oracles.

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// numerator / 2^exponent
struct Dyadic {
  Integer numerator;
  unsigned exponent = 0;

  double value() const;
};

/// Polynomial in one variable; coefficients[i] belongs to t^i, the last one is not zero, the zero polynomial has none.
/// Degree at most 7.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(Integer constant);
  Polynomial(Integer constant, Integer slope);

  bool is_zero() const { return c_.empty(); }
  int degree() const { return static_cast<int>(c_.size()) - 1; }  ///< -1 for the zero polynomial
  const Integer& operator[](std::size_t i) const { return c_[i]; }

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);

  Polynomial derivative() const;

  /// Divided by the greatest common divisor of its coefficients (which is positive).
  Polynomial primitive_part() const;

  int sign_at(const Dyadic& t) const;

  /// The common strict sign of all Bernstein coefficients on [low, high], or 0 when they have none.
  int bernstein_sign(const Dyadic& low, const Dyadic& high) const;

 private:
  friend struct Division;
  void trim();

  boost::container::static_vector<Integer, 8> c_;
};

/// Pseudo-division: factor * dividend = quotient * divisor + remainder for some positive integer factor.
struct Division {
  Division(const Polynomial& dividend, const Polynomial& divisor);

  Polynomial quotient;
  Polynomial remainder;
};

Polynomial greatest_common_divisor(Polynomial a, Polynomial b);

/// Counts distinct roots by Sturm's theorem.
class SturmChain {
 public:
  explicit SturmChain(const Polynomial& p);  ///< p square-free and not zero

  const Polynomial& polynomial() const { return chain_.front(); }
  int roots_between(const Dyadic& low, const Dyadic& high) const;  ///< in (low, high]

 private:
  int variations(const Dyadic& t) const;

  std::vector<Polynomial> chain_;
};

/// A real algebraic number: a dyadic number, or the one root of a square-free polynomial in an open interval.
class AlgebraicNumber {
 public:
  explicit AlgebraicNumber(Dyadic exact) : low_(exact), high_(std::move(exact)) {}
  AlgebraicNumber(std::shared_ptr<const SturmChain> chain, Dyadic low, Dyadic high)
      : chain_(std::move(chain)), low_(std::move(low)), high_(std::move(high)) {}

  /// The exact sign of p at this number.
  int sign_of(const Polynomial& p);

  /// Halves the interval until it is no longer than 2^-bits.
  void refine(unsigned bits);

  double low() const { return low_.value(); }
  double high() const { return high_.value(); }

 private:
  void halve();

  std::shared_ptr<const SturmChain> chain_;  // none: exact
  Dyadic low_;
  Dyadic high_;
};

/// The distinct roots of p, which is not zero, in the open interval (0, 1), in ascending order.
std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& p);

}  // namespace lostopos::test
