#pragma once

#include <boost/container/static_vector.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <utility>

namespace lostopos::test {

// Integer polynomials in exact arithmetic, for oracles.

/// Of any size; up to 512 bits without allocation.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

/// numerator / 2^exponent
struct Dyadic {
  Integer numerator;
  unsigned exponent = 0;

  /// The number x, in [0, 1].
  static Dyadic of(double x);

  /// The double that is equal or next below, or above; of a number in [0, 1].
  double rounded_down() const;
  double rounded_up() const;
};

/// Their numerators over the same power of two.
std::pair<Integer, Integer> alike(const Dyadic& a, const Dyadic& b);

Dyadic midpoint(const Dyadic& a, const Dyadic& b);
Dyadic operator+(const Dyadic& a, const Dyadic& b);
bool operator<(const Dyadic& a, const Dyadic& b);

/// Polynomial in one variable; coefficients[i] belongs to t^i, the last one is not zero, the zero polynomial has none.
/// Degree at most 7.
class Polynomial {
 public:
  using Coefficients = boost::container::static_vector<Integer, 8>;

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

  /// The coefficients of Bernstein's form on [low, high], low < high, all times one positive number.
  Coefficients bernstein(const Dyadic& low, const Dyadic& high) const;

 private:
  friend struct Division;
  void trim();

  Coefficients c_;
};

/// Changes of sign from one coefficient to the next, zeros left out. Of Bernstein coefficients they are as many as the
/// roots in the open interval, each counted by its multiplicity, or more by an even number (Descartes).
int sign_changes(const Polynomial::Coefficients& c);

/// The common strict sign of all coefficients, or 0 when they have none.
int common_sign(const Polynomial::Coefficients& c);

/// Pseudo-division: factor * dividend = quotient * divisor + remainder for some positive integer factor.
struct Division {
  Division(const Polynomial& dividend, const Polynomial& divisor);

  Polynomial quotient;
  Polynomial remainder;
};

Polynomial greatest_common_divisor(Polynomial a, Polynomial b);

}  // namespace lostopos::test
