#include "tests/support/exact_polynomial.h"

#include <algorithm>
#include <cmath>

namespace lostopos::test {
namespace {

namespace mp = boost::multiprecision;

Integer shifted(Integer value, unsigned bits) {
  value <<= bits;
  return value;
}

Dyadic midpoint(const Dyadic& a, const Dyadic& b) {
  const unsigned e = std::max(a.exponent, b.exponent);
  return {shifted(a.numerator, e - a.exponent) + shifted(b.numerator, e - b.exponent), e + 1};
}

// Appends the roots in (low, high); p is not zero at high, unless high is a root already reported or 1.
void isolate(const std::shared_ptr<const SturmChain>& chain, const Dyadic& low, const Dyadic& high,
             std::vector<AlgebraicNumber>& roots) {
  const Polynomial& p = chain->polynomial();
  int count = chain->roots_between(low, high);
  if (p.sign_at(high) == 0) --count;
  if (count == 0) return;
  if (count == 1) {
    roots.emplace_back(chain, low, high);
    return;
  }
  const Dyadic middle = midpoint(low, high);
  isolate(chain, low, middle, roots);
  if (p.sign_at(middle) == 0) roots.emplace_back(middle);
  isolate(chain, middle, high, roots);
}

}  // namespace

double Dyadic::value() const {
  // Rounded to 64 bits by truncation first, so that numerators beyond the range of double are no trouble.
  if (numerator == 0) return 0;
  Integer magnitude = mp::abs(numerator);
  const int excess = static_cast<int>(mp::msb(magnitude)) - 63;
  if (excess > 0) magnitude >>= static_cast<unsigned>(excess);
  const double mantissa = magnitude.convert_to<double>() * numerator.sign();
  return std::ldexp(mantissa, std::max(excess, 0) - static_cast<int>(exponent));
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

int Polynomial::bernstein_sign(const Dyadic& low, const Dyadic& high) const {
  if (is_zero()) return 0;
  // q(s), a positive multiple of p(low + s (high - low)).
  const unsigned e = std::max(low.exponent, high.exponent);
  const Integer a = shifted(low.numerator, e - low.exponent);
  const Polynomial line(a, shifted(high.numerator, e - high.exponent) - a);
  Polynomial q;
  unsigned shift = 0;
  for (std::size_t i = c_.size(); i-- > 0; shift += e) q = q * line + Polynomial(shifted(c_[i], shift));

  // b_j = sum_i C(j, i) / C(n, i) q_i, times n! to stay with integers.
  static constexpr std::array<int, 8> factorial = {1, 1, 2, 6, 24, 120, 720, 5040};
  const auto n = static_cast<std::size_t>(q.degree());
  int sign = 0;
  for (std::size_t j = 0; j + 1 <= q.c_.size(); ++j) {
    Integer b = 0;
    for (std::size_t i = 0; i <= j; ++i) b += q.c_[i] * (factorial[j] / factorial[j - i] * factorial[n - i]);
    const int s = b.sign();
    if (s == 0 || (sign != 0 && s != sign)) return 0;
    sign = s;
  }
  return sign;
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

SturmChain::SturmChain(const Polynomial& p) : chain_{p} {
  Polynomial next = p.derivative();
  while (!next.is_zero()) {
    chain_.push_back(next.primitive_part());
    next = Polynomial() - Division(chain_[chain_.size() - 2], chain_.back()).remainder;
  }
}

int SturmChain::variations(const Dyadic& t) const {
  int count = 0;
  int previous = 0;
  for (const Polynomial& p : chain_) {
    const int sign = p.sign_at(t);
    if (sign * previous < 0) ++count;
    if (sign != 0) previous = sign;
  }
  return count;
}

int SturmChain::roots_between(const Dyadic& low, const Dyadic& high) const {
  return variations(low) - variations(high);
}

void AlgebraicNumber::halve() {
  const Dyadic middle = midpoint(low_, high_);
  const Polynomial& p = chain_->polynomial();
  const int sign = p.sign_at(middle);
  if (sign == 0) {
    low_ = high_ = middle;
    chain_.reset();
    return;
  }
  // A simple root changes the sign; the ends of the interval may be other roots, then Sturm decides.
  const int high_sign = p.sign_at(high_);
  const bool in_upper_half = high_sign != 0 ? sign != high_sign : chain_->roots_between(low_, middle) == 0;
  (in_upper_half ? low_ : high_) = middle;
}

void AlgebraicNumber::refine(unsigned bits) {
  while (chain_ && std::max(low_.exponent, high_.exponent) < bits) halve();
}

int AlgebraicNumber::sign_of(const Polynomial& p) {
  if (p.is_zero()) return 0;
  constexpr int cheap_attempts = 6;
  for (int attempt = 0; chain_; ++attempt) {
    const int sign = p.bernstein_sign(low_, high_);
    if (sign != 0) return sign;
    if (attempt == cheap_attempts) {
      // A common factor with a root in the interval has this number as its root.
      const Polynomial common = greatest_common_divisor(p, chain_->polynomial());
      if (common.degree() > 0 && common.sign_at(low_) * common.sign_at(high_) < 0) return 0;
      if (common.degree() > 0) {
        const SturmChain chain(common);
        if (chain.roots_between(low_, high_) - (common.sign_at(high_) == 0 ? 1 : 0) > 0) return 0;
      }
    }
    halve();
  }
  return p.sign_at(low_);
}

std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& p) {
  const Dyadic zero{0, 0};
  const Dyadic one{1, 0};
  std::vector<AlgebraicNumber> roots;
  if (p.degree() < 1 || p.bernstein_sign(zero, one) != 0) return roots;
  const Polynomial repeated = greatest_common_divisor(p, p.derivative());
  const Polynomial simple = (repeated.degree() > 0 ? Division(p, repeated).quotient : p).primitive_part();
  isolate(std::make_shared<const SturmChain>(simple), zero, one, roots);
  return roots;
}

}  // namespace lostopos::test
