#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/sheet/velocity/tree/tree_kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "FoamSim/sheet/velocity/inverse_root-inl.h"

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
template <class Real>
using Lanes = hn::CappedTag<Real, tree_lanes>;
template <class Real>
using VecOf = hn::Vec<Lanes<Real>>;

using Offset = std::array<double, 3>;

template <class Vec>
struct Body {
  Vec x, y, z, gx, gy, gz;
};

template <class Vec>
struct Sums {
  Vec v[9];
};

template <class Vec>
HWY_INLINE Vec cross(Vec sum, Vec a, Vec b, Vec c, Vec e) {
  return hn::NegMulAdd(c, e, hn::MulAdd(a, b, sum));
}

template <TreeTerms terms, class Real, class Vec>
HWY_INLINE void add_pair(const Body<Vec>& t, const TreeBodies<Real>& s, std::size_t i, Vec delta2, Sums<Vec>& sums) {
  const Lanes<Real> d;
  const Vec dx = hn::Sub(t.x, hn::Set(d, s.x[i])), dy = hn::Sub(t.y, hn::Set(d, s.y[i])),
            dz = hn::Sub(t.z, hn::Set(d, s.z[i]));
  const Vec gx = hn::Set(d, s.gx[i]), gy = hn::Set(d, s.gy[i]), gz = hn::Set(d, s.gz[i]);
  const Vec inverse = inverse_root(d, hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::MulAdd(dz, dz, delta2))));
  constexpr std::size_t u = terms == TreeTerms::all ? 3 : 0;
  if constexpr (terms != TreeTerms::velocity) {
    sums.v[0] = hn::MulAdd(gx, inverse, sums.v[0]);
    sums.v[1] = hn::MulAdd(gy, inverse, sums.v[1]);
    sums.v[2] = hn::MulAdd(gz, inverse, sums.v[2]);
  }
  if constexpr (terms != TreeTerms::potential) {
    const Vec weight = hn::Mul(hn::Mul(inverse, inverse), inverse);
    const Vec wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy), wz = hn::Mul(weight, dz);
    sums.v[u] = cross(sums.v[u], gy, wz, gz, wy);
    sums.v[u + 1] = cross(sums.v[u + 1], gz, wx, gx, wz);
    sums.v[u + 2] = cross(sums.v[u + 2], gx, wy, gy, wx);
    if constexpr (terms == TreeTerms::all) {
      const Vec product = hn::MulAdd(t.gx, gx, hn::MulAdd(t.gy, gy, hn::Mul(t.gz, gz)));
      sums.v[6] = hn::NegMulAdd(product, wx, sums.v[6]);
      sums.v[7] = hn::NegMulAdd(product, wy, sums.v[7]);
      sums.v[8] = hn::NegMulAdd(product, wz, sums.v[8]);
    }
  }
}

template <TreeTerms terms, class Real>
HWY_INLINE Body<VecOf<Real>> load(const TreeBodies<Real>& targets, const Offset& offset, std::size_t t) {
  const Lanes<Real> d;
  Body<VecOf<Real>> body;
  body.x = hn::Add(hn::LoadU(d, targets.x + t), hn::Set(d, static_cast<Real>(offset[0])));
  body.y = hn::Add(hn::LoadU(d, targets.y + t), hn::Set(d, static_cast<Real>(offset[1])));
  body.z = hn::Add(hn::LoadU(d, targets.z + t), hn::Set(d, static_cast<Real>(offset[2])));
  const bool strengths = terms == TreeTerms::all;
  body.gx = strengths ? hn::LoadU(d, targets.gx + t) : hn::Zero(d);
  body.gy = strengths ? hn::LoadU(d, targets.gy + t) : hn::Zero(d);
  body.gz = strengths ? hn::LoadU(d, targets.gz + t) : hn::Zero(d);
  return body;
}

template <TreeTerms terms, class Real>
HWY_INLINE void put(const Sums<VecOf<Real>>& sums, std::size_t t, std::size_t count, double* out, std::size_t stride) {
  const Lanes<Real> d;
  HWY_ALIGN Real values[tree_lanes] = {};
  for (std::size_t c = 0; c < components(terms); ++c) {
    hn::Store(sums.v[c], d, values);
    for (std::size_t i = 0; i < count; ++i) out[c * stride + t + i] += static_cast<double>(values[i]);
  }
}

// Two groups of targets at a time, so that each source is fetched half as often.
template <TreeTerms terms, class Real>
void add_all(const TreeBodies<Real>& targets, const TreeBodies<Real>& sources, const Offset& offset,
             double delta_squared, double* out, std::size_t stride) {
  const Lanes<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto delta2 = hn::Set(d, static_cast<Real>(delta_squared)), none = hn::Zero(d);
  std::size_t t = 0;
  for (; t + lanes < targets.size; t += 2 * lanes) {
    const auto one = load<terms>(targets, offset, t), two = load<terms>(targets, offset, t + lanes);
    Sums<VecOf<Real>> first{{none, none, none, none, none, none, none, none, none}}, second = first;
    for (std::size_t i = 0; i < sources.size; ++i) {
      add_pair<terms>(one, sources, i, delta2, first);
      add_pair<terms>(two, sources, i, delta2, second);
    }
    put<terms, Real>(first, t, lanes, out, stride);
    put<terms, Real>(second, t + lanes, HWY_MIN(lanes, targets.size - t - lanes), out, stride);
  }
  if (t >= targets.size) return;
  const auto last = load<terms>(targets, offset, t);
  Sums<VecOf<Real>> sums{{none, none, none, none, none, none, none, none, none}};
  for (std::size_t i = 0; i < sources.size; ++i) add_pair<terms>(last, sources, i, delta2, sums);
  put<terms, Real>(sums, t, targets.size - t, out, stride);
}

template <class Real>
void choose_terms(const TreeBodies<Real>& targets, const TreeBodies<Real>& sources, const Offset& offset,
                  double delta_squared, TreeTerms terms, double* out, std::size_t stride) {
  switch (terms) {
    case TreeTerms::potential:
      return add_all<TreeTerms::potential>(targets, sources, offset, delta_squared, out, stride);
    case TreeTerms::velocity:
      return add_all<TreeTerms::velocity>(targets, sources, offset, delta_squared, out, stride);
    case TreeTerms::all:
      return add_all<TreeTerms::all>(targets, sources, offset, delta_squared, out, stride);
  }
}

void add_doubles(const TreeBodies<double>& targets, const TreeBodies<double>& sources, const Offset& offset,
                 double delta_squared, TreeTerms terms, double* out, std::size_t stride) {
  choose_terms(targets, sources, offset, delta_squared, terms, out, stride);
}

void add_singles(const TreeBodies<float>& targets, const TreeBodies<float>& sources, const Offset& offset,
                 double delta_squared, TreeTerms terms, double* out, std::size_t stride) {
  choose_terms(targets, sources, offset, delta_squared, terms, out, stride);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(add_doubles);
HWY_EXPORT(add_singles);

void add_to_targets(const TreeBodies<double>& targets, const TreeBodies<double>& sources,
                    const std::array<double, 3>& offset, double delta_squared, TreeTerms terms, double* out,
                    std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add_doubles)(targets, sources, offset, delta_squared, terms, out, stride);
}

void add_to_targets(const TreeBodies<float>& targets, const TreeBodies<float>& sources,
                    const std::array<double, 3>& offset, double delta_squared, TreeTerms terms, double* out,
                    std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add_singles)(targets, sources, offset, delta_squared, terms, out, stride);
}

}  // namespace foamsim
#endif  // HWY_ONCE
