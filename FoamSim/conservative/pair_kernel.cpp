#include "FoamSim/conservative/pair_kernel.h"

#include <cstddef>

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/conservative/pair_kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
// Eight lanes at most, and always eight triangles at a time, so that the sum over lanes has one order everywhere.
using Doubles = hn::CappedTag<double, 8>;
using Vec = hn::Vec<Doubles>;
constexpr std::size_t kChunk = 8;

// A triangle's place and strength in every lane, or those of eight triangles.
struct Bodies {
  Vec x, y, z, gx, gy, gz;
};

HWY_INLINE Bodies one(const VortexSources& a, std::size_t t) {
  const Doubles d;
  return {hn::Set(d, a.x[t]),  hn::Set(d, a.y[t]),  hn::Set(d, a.z[t]),
          hn::Set(d, a.gx[t]), hn::Set(d, a.gy[t]), hn::Set(d, a.gz[t])};
}

HWY_INLINE Bodies several(const VortexSources& a, std::size_t s) {
  const Doubles d;
  return {hn::Load(d, &a.x[s]),  hn::Load(d, &a.y[s]),  hn::Load(d, &a.z[s]),
          hn::Load(d, &a.gx[s]), hn::Load(d, &a.gy[s]), hn::Load(d, &a.gz[s])};
}

HWY_INLINE void add_to(double* place, Vec value) {
  const Doubles d;
  hn::Store(hn::Add(hn::Load(d, place), value), d, place);
}

// What the lanes of s collect from a row of triangles t, kept in registers.
struct Sums {
  Vec px, py, pz, bx, by, bz, ux, uy, uz;
};

// place += a b
HWY_INLINE void add_product(double* place, Vec a, Vec b) {
  const Doubles d;
  hn::Store(hn::MulAdd(a, b, hn::Load(d, place)), d, place);
}

// a b − c e + sum
HWY_INLINE Vec add_cross(Vec sum, Vec a, Vec b, Vec c, Vec e) {
  return hn::NegMulAdd(c, e, hn::MulAdd(a, b, sum));
}

HWY_INLINE void add_cross(double* place, Vec a, Vec b, Vec c, Vec e) {
  const Doubles d;
  hn::Store(add_cross(hn::Load(d, place), a, b, c, e), d, place);
}

// The pairs of t with the lanes of s: to the lanes' sums, and lane by lane to t's (`own`, kChunk apart; forces with the
// other sign). Arithmetic is what takes the time (the root and the division hide behind it), and fused it is less.
template <bool all>
HWY_INLINE void add_pairs(const Bodies& t, const Bodies& s, Vec delta2, Vec counts, Sums& sums, double* own) {
  const Vec dx = hn::Sub(t.x, s.x), dy = hn::Sub(t.y, s.y), dz = hn::Sub(t.z, s.z);
  const Vec r2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::MulAdd(dz, dz, delta2)));
  const Vec inverse = hn::Div(counts, hn::Sqrt(r2));
  add_product(own, s.gx, inverse);
  add_product(own + kChunk, s.gy, inverse);
  add_product(own + 2 * kChunk, s.gz, inverse);
  sums.px = hn::MulAdd(t.gx, inverse, sums.px);
  sums.py = hn::MulAdd(t.gy, inverse, sums.py);
  sums.pz = hn::MulAdd(t.gz, inverse, sums.pz);
  if constexpr (all) {
    const Vec weight = hn::Mul(hn::Mul(inverse, inverse), inverse);
    const Vec wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy), wz = hn::Mul(weight, dz);
    const Vec product = hn::MulAdd(t.gx, s.gx, hn::MulAdd(t.gy, s.gy, hn::Mul(t.gz, s.gz)));
    add_product(own + 3 * kChunk, product, wx);
    add_product(own + 4 * kChunk, product, wy);
    add_product(own + 5 * kChunk, product, wz);
    sums.bx = hn::MulAdd(product, wx, sums.bx);
    sums.by = hn::MulAdd(product, wy, sums.by);
    sums.bz = hn::MulAdd(product, wz, sums.bz);
    add_cross(own + 6 * kChunk, s.gy, wz, s.gz, wy);
    add_cross(own + 7 * kChunk, s.gz, wx, s.gx, wz);
    add_cross(own + 8 * kChunk, s.gx, wy, s.gy, wx);
    sums.ux = add_cross(sums.ux, t.gz, wy, t.gy, wz);
    sums.uy = add_cross(sums.uy, t.gx, wz, t.gz, wx);
    sums.uz = add_cross(sums.uz, t.gy, wx, t.gx, wy);
  }
}

template <bool all>
HWY_INLINE void add_sums(const Sums& sums, double* out, std::size_t stride) {
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

// 1 in the lanes from s on whose triangle is behind t, else 0.
HWY_INLINE Vec behind(std::size_t s, std::size_t t) {
  const Doubles d;
  const Vec index = hn::Add(hn::Set(d, static_cast<double>(s)), hn::Iota(d, 0.0));
  return hn::IfThenElseZero(hn::Gt(index, hn::Set(d, static_cast<double>(t))), hn::Set(d, 1.0));
}

template <bool all>
void add_row(const VortexSources& sources, std::size_t row, double delta_squared, double* out, std::size_t stride) {
  const Doubles d;
  constexpr std::size_t components = all ? all_components : potential_components;
  constexpr std::size_t size = components * kChunk;
  HWY_ALIGN double own[pair_row * size] = {};
  const Vec delta2 = hn::Set(d, delta_squared), whole = hn::Set(d, 1.0), none = hn::Zero(d);
  const std::size_t first = row * pair_row;
  for (std::size_t s = first; s < stride; s += hn::Lanes(d)) {
    const Bodies lanes = several(sources, s);
    Sums sums{none, none, none, none, none, none, none, none, none};
    double* at = own + s % kChunk;
    if (s < first + pair_row)
      for (std::size_t t = first; t < s + hn::Lanes(d); ++t)
        add_pairs<all>(one(sources, t), lanes, delta2, behind(s, t), sums, at + (t - first) * size);
    else
      for (std::size_t t = first; t < first + pair_row; ++t)
        add_pairs<all>(one(sources, t), lanes, delta2, whole, sums, at + (t - first) * size);
    add_sums<all>(sums, out + s, stride);
  }
  for (std::size_t t = 0; t < pair_row; ++t)
    for (std::size_t c = 0; c < components; ++c) {
      const double* v = own + t * size + c * kChunk;
      const double sum = ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
      out[c * stride + first + t] += c / 3 == 1 ? -sum : sum;
    }
}

void add(const VortexSources& sources, std::size_t row, double delta_squared, bool all, double* out,
         std::size_t stride) {
  if (all)
    add_row<true>(sources, row, delta_squared, out, stride);
  else
    add_row<false>(sources, row, delta_squared, out, stride);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(add);

void add_pair_row(const VortexSources& sources, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add)(sources, row, delta_squared, all, out, stride);
}

}  // namespace foamsim
#endif  // HWY_ONCE
