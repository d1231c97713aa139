#pragma once

#include <memory>
#include <vector>

#include "tests/support/exact_polynomial.h"

namespace lostopos::test {

/// A real algebraic number: a dyadic number, or the one root of a polynomial in an open interval, a simple one.
class AlgebraicNumber {
 public:
  explicit AlgebraicNumber(Dyadic exact) : low_(exact), high_(std::move(exact)) {}

  /// `sign_below`: the polynomial's in the interval, below the root.
  AlgebraicNumber(std::shared_ptr<const Polynomial> polynomial, int sign_below, Dyadic low, Dyadic high)
      : polynomial_(std::move(polynomial)), sign_below_(sign_below), low_(std::move(low)), high_(std::move(high)) {}

  /// The exact sign of p at this number.
  int sign_of(const Polynomial& p);

  /// Shortens the interval until it is no longer than 2^-bits.
  void refine(unsigned bits);

  /// Makes t one of the interval's ends, if it is inside, or the number itself; whether it was inside.
  bool cut(const Dyadic& t);

  const Dyadic& low() const { return low_; }
  const Dyadic& high() const { return high_; }

 private:
  void approach();

  std::shared_ptr<const Polynomial> polynomial_;  // none: exact
  int sign_below_ = 0;
  Dyadic low_;
  Dyadic high_;
};

/// The distinct roots of p, which is not zero, in the open interval (0, 1), in ascending order.
std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& p);

}  // namespace lostopos::test
