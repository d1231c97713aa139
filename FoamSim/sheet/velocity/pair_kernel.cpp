#include "FoamSim/sheet/velocity/pair_kernel.h"

#include <cstddef>

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/sheet/velocity/pair_kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "FoamSim/sheet/velocity/inverse_root-inl.h"

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
// So many triangles at a time, whatever lanes the machine has, so that the sum over lanes has one order everywhere.
template <class Real>
constexpr std::size_t kChunk = 64 / sizeof(Real);
template <class Real>
using Lanes = hn::CappedTag<Real, kChunk<Real>>;
template <class Real>
using VecOf = hn::Vec<Lanes<Real>>;

// A triangle's place and strength in every lane, or those of several triangles.
template <class Vec>
struct Bodies {
  Vec x, y, z, gx, gy, gz;
};

template <class Real>
HWY_INLINE Bodies<VecOf<Real>> one(const PairBodies<Real>& a, std::size_t t) {
  const Lanes<Real> d;
  return {hn::Set(d, a.x[t]),  hn::Set(d, a.y[t]),  hn::Set(d, a.z[t]),
          hn::Set(d, a.gx[t]), hn::Set(d, a.gy[t]), hn::Set(d, a.gz[t])};
}

template <class Real>
HWY_INLINE Bodies<VecOf<Real>> several(const PairBodies<Real>& a, std::size_t s) {
  const Lanes<Real> d;
  return {hn::Load(d, &a.x[s]),  hn::Load(d, &a.y[s]),  hn::Load(d, &a.z[s]),
          hn::Load(d, &a.gx[s]), hn::Load(d, &a.gy[s]), hn::Load(d, &a.gz[s])};
}

HWY_INLINE void add_to(double* place, VecOf<double> value) {
  const Lanes<double> d;
  hn::Store(hn::Add(hn::Load(d, place), value), d, place);
}

HWY_INLINE void add_to(double* place, VecOf<float> value) {
  const Lanes<float> d;
  const hn::CappedTag<double, kChunk<float>> wide;
  const hn::Rebind<float, decltype(wide)> narrow;
  HWY_ALIGN float values[kChunk<float>];
  hn::Store(value, d, values);
  for (std::size_t i = 0; i < hn::Lanes(d); i += hn::Lanes(wide)) {
    const auto more = hn::PromoteTo(wide, hn::Load(narrow, values + i));
    hn::Store(hn::Add(hn::Load(wide, place + i), more), wide, place + i);
  }
}

// What the lanes of s collect from a row of triangles t, kept in registers.
template <class Vec>
struct Sums {
  Vec px, py, pz, bx, by, bz, ux, uy, uz;
};

// place += a b
template <class Real, class Vec>
HWY_INLINE void add_product(Real* place, Vec a, Vec b) {
  const Lanes<Real> d;
  hn::Store(hn::MulAdd(a, b, hn::Load(d, place)), d, place);
}

// a b − c e + sum
template <class Vec>
HWY_INLINE Vec cross_and(Vec sum, Vec a, Vec b, Vec c, Vec e) {
  return hn::NegMulAdd(c, e, hn::MulAdd(a, b, sum));
}

template <class Real, class Vec>
HWY_INLINE void add_cross(Real* place, Vec a, Vec b, Vec c, Vec e) {
  const Lanes<Real> d;
  hn::Store(cross_and(hn::Load(d, place), a, b, c, e), d, place);
}

// a / √x, x > 0.
HWY_INLINE VecOf<double> over_root(VecOf<double> a, VecOf<double> x) {
  return hn::Div(a, hn::Sqrt(x));
}
HWY_INLINE VecOf<float> over_root(VecOf<float> a, VecOf<float> x) {
  return hn::Mul(a, inverse_root(Lanes<float>(), x));
}

// The pairs of t with the lanes of s: to the lanes' sums, and lane by lane to t's (`own`, kChunk apart; forces with the
// other sign). Arithmetic is what takes the time (the root and the division hide behind it), and fused it is less.
template <bool all, class Real, class Vec>
HWY_INLINE void add_pairs(const Bodies<Vec>& t, const Bodies<Vec>& s, Vec delta2, Vec counts, Sums<Vec>& sums,
                          Real* own) {
  constexpr std::size_t chunk = kChunk<Real>;
  const Vec dx = hn::Sub(t.x, s.x), dy = hn::Sub(t.y, s.y), dz = hn::Sub(t.z, s.z);
  const Vec r2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::MulAdd(dz, dz, delta2)));
  const Vec inverse = over_root(counts, r2);
  add_product(own, s.gx, inverse);
  add_product(own + chunk, s.gy, inverse);
  add_product(own + 2 * chunk, s.gz, inverse);
  sums.px = hn::MulAdd(t.gx, inverse, sums.px);
  sums.py = hn::MulAdd(t.gy, inverse, sums.py);
  sums.pz = hn::MulAdd(t.gz, inverse, sums.pz);
  if constexpr (all) {
    const Vec weight = hn::Mul(hn::Mul(inverse, inverse), inverse);
    const Vec wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy), wz = hn::Mul(weight, dz);
    const Vec product = hn::MulAdd(t.gx, s.gx, hn::MulAdd(t.gy, s.gy, hn::Mul(t.gz, s.gz)));
    add_product(own + 3 * chunk, product, wx);
    add_product(own + 4 * chunk, product, wy);
    add_product(own + 5 * chunk, product, wz);
    sums.bx = hn::MulAdd(product, wx, sums.bx);
    sums.by = hn::MulAdd(product, wy, sums.by);
    sums.bz = hn::MulAdd(product, wz, sums.bz);
    add_cross(own + 6 * chunk, s.gy, wz, s.gz, wy);
    add_cross(own + 7 * chunk, s.gz, wx, s.gx, wz);
    add_cross(own + 8 * chunk, s.gx, wy, s.gy, wx);
    sums.ux = cross_and(sums.ux, t.gz, wy, t.gy, wz);
    sums.uy = cross_and(sums.uy, t.gx, wz, t.gz, wx);
    sums.uz = cross_and(sums.uz, t.gy, wx, t.gx, wy);
  }
}

template <bool all, class Vec>
HWY_INLINE void add_sums(const Sums<Vec>& sums, double* out, std::size_t stride) {
  add_to(out, sums.px);
  add_to(out + stride, sums.py);
  add_to(out + 2 * stride, sums.pz);
  if constexpr (all) {
    add_to(out + 3 * stride, sums.bx);
    add_to(out + 4 * stride, sums.by);
    add_to(out + 5 * stride, sums.bz);
    add_to(out + 6 * stride, sums.ux);
    add_to(out + 7 * stride, sums.uy);
    add_to(out + 8 * stride, sums.uz);
  }
}

HWY_INLINE double sum_of_lanes(const double* v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

HWY_INLINE double sum_of_lanes(const float* v) {
  double sums[8];
  for (std::size_t i = 0; i < 8; ++i) sums[i] = static_cast<double>(v[i]) + static_cast<double>(v[i + 8]);
  return sum_of_lanes(sums);
}

// 1 in the lanes from s on whose triangle is behind t, else 0.
template <class Real>
HWY_INLINE VecOf<Real> behind(std::size_t s, std::size_t t) {
  const Lanes<Real> d;
  const auto index = hn::Add(hn::Set(d, static_cast<Real>(s % pair_row)), hn::Iota(d, Real{0}));
  return hn::IfThenElseZero(hn::Gt(index, hn::Set(d, static_cast<Real>(t % pair_row))), hn::Set(d, Real{1}));
}

template <bool all, class Real>
void add_row(const PairBodies<Real>& bodies, std::size_t row, double delta_squared, double* out, std::size_t stride) {
  const Lanes<Real> d;
  constexpr std::size_t components = all ? all_components : potential_components;
  constexpr std::size_t size = components * kChunk<Real>;
  HWY_ALIGN Real own[pair_row * size] = {};
  const auto delta2 = hn::Set(d, static_cast<Real>(delta_squared)), whole = hn::Set(d, Real{1}), none = hn::Zero(d);
  const std::size_t first = row * pair_row;
  for (std::size_t s = first; s < stride; s += hn::Lanes(d)) {
    const auto lanes = several(bodies, s);
    Sums<VecOf<Real>> sums{none, none, none, none, none, none, none, none, none};
    Real* at = own + s % kChunk<Real>;
    if (s < first + pair_row)
      for (std::size_t t = first; t < s + hn::Lanes(d); ++t)
        add_pairs<all>(one(bodies, t), lanes, delta2, behind<Real>(s, t), sums, at + (t - first) * size);
    else
      for (std::size_t t = first; t < first + pair_row; ++t)
        add_pairs<all>(one(bodies, t), lanes, delta2, whole, sums, at + (t - first) * size);
    add_sums<all>(sums, out + s, stride);
  }
  for (std::size_t t = 0; t < pair_row; ++t)
    for (std::size_t c = 0; c < components; ++c) {
      const double sum = sum_of_lanes(own + t * size + c * kChunk<Real>);
      out[c * stride + first + t] += c / 3 == 1 ? -sum : sum;
    }
}

template <class Real>
void add(const PairBodies<Real>& bodies, std::size_t row, double delta_squared, bool all, double* out,
         std::size_t stride) {
  if (all)
    add_row<true>(bodies, row, delta_squared, out, stride);
  else
    add_row<false>(bodies, row, delta_squared, out, stride);
}

void add_doubles(const PairBodies<double>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                 std::size_t stride) {
  add(bodies, row, delta_squared, all, out, stride);
}

void add_singles(const PairBodies<float>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                 std::size_t stride) {
  add(bodies, row, delta_squared, all, out, stride);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(add_doubles);
HWY_EXPORT(add_singles);

void add_pair_row(const PairBodies<double>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add_doubles)(bodies, row, delta_squared, all, out, stride);
}

void add_pair_row(const PairBodies<float>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add_singles)(bodies, row, delta_squared, all, out, stride);
}

}  // namespace foamsim
#endif  // HWY_ONCE
