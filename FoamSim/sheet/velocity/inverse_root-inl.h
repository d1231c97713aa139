// Included by kernels that Highway compiles for each instruction set, once for each.
#if defined(FOAMSIM_INVERSE_ROOT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FOAMSIM_INVERSE_ROOT_INL
#undef FOAMSIM_INVERSE_ROOT_INL
#else
#define FOAMSIM_INVERSE_ROOT_INL
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Half of the exponent's bits, negated: 1/√x within 3.44% (Lomont 2003; Moroz et al. 2018).
inline constexpr std::uint32_t inverse_root_guess(float) {
  return 0x5F375A86U;
}
inline constexpr std::uint64_t inverse_root_guess(double) {
  return 0x5FE6EB50C7B537A9U;
}

/// A better 1/√x from y within 3.44% of it: y (1 + h q(h)), h = 1 − x y², where q is the minimax polynomial of third
/// degree of (1/√(1 − h) − 1)/h for such h. Within 2.4e-8 and rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V nearer_inverse_root(D d, V x, V y) {
  using Real = hn::TFromD<D>;
  const V h = hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, Real{1}));
  V q = hn::MulAdd(h, hn::Set(d, static_cast<Real>(0.273643682)), hn::Set(d, static_cast<Real>(0.313946738)));
  q = hn::MulAdd(h, q, hn::Set(d, static_cast<Real>(0.375001724)));
  q = hn::MulAdd(h, q, hn::Set(d, static_cast<Real>(0.499998315)));
  return hn::MulAdd(hn::Mul(y, h), q, y);
}

/// 1/√x of positive normal numbers, to an ulp or two, and the same bits on all machines that have fused multiplication:
/// a guess, a polynomial, and in double precision one of Householder's steps, y (1 + h/2 + 3h²/8). A root and a
/// division take twice as long where the vectors are wide. 0 for 0, and nearly that for what is too large for the
/// precision.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverse_root(D d, V x) {
  using Real = hn::TFromD<D>;
  // Where x is infinite the steps would give no number.
  x = hn::Min(x, hn::Set(d, std::numeric_limits<Real>::max()));
  const hn::RebindToUnsigned<D> bits;
  V y = hn::BitCast(d, hn::Sub(hn::Set(bits, inverse_root_guess(Real{})), hn::ShiftRight<1>(hn::BitCast(bits, x))));
  y = nearer_inverse_root(d, x, y);
  if constexpr (sizeof(Real) == 8) {
    const V h = hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, Real{1}));
    y = hn::MulAdd(hn::Mul(y, h), hn::MulAdd(h, hn::Set(d, Real{0.375}), hn::Set(d, Real{0.5})), y);
  }
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), y);
}

/// 1/√x³ of numbers from 1e-12 to 1e25 (beyond, down to 0), within 2.6e-7 and rounding: a guess y and y³ p(h), h = 1 −
/// x y², where p is the minimax polynomial of fourth degree of (1 − h)^(−3/2). The same bits on the machines that
/// inverse_root has them on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverse_root_cubed(D d, V x) {
  const hn::RebindToUnsigned<D> bits;
  const V y = hn::BitCast(d, hn::Sub(hn::Set(bits, inverse_root_guess(0.0F)), hn::ShiftRight<1>(hn::BitCast(bits, x))));
  const V square = hn::Mul(y, y), h = hn::NegMulAdd(x, square, hn::Set(d, 1.0F));
  V p = hn::MulAdd(h, hn::Set(d, 2.46489120F), hn::Set(d, 2.20332670F));
  p = hn::MulAdd(h, p, hn::Set(d, 1.87502933F));
  p = hn::MulAdd(h, p, hn::Set(d, 1.49998152F));
  p = hn::MulAdd(h, p, hn::Set(d, 1.0F));
  return hn::Mul(hn::Mul(square, y), p);
}

}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
