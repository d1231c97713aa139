#include "FoamSim/sheet/velocity/tree/near_velocity.h"

#include <algorithm>

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/sheet/velocity/tree/near_velocity.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "FoamSim/sheet/velocity/inverse_root-inl.h"

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, tree_lanes>;
using Vec = hn::Vec<Lanes>;

struct Vec3s {
  Vec x, y, z;
};

HWY_INLINE Vec3s load(const TreeBodies<float>& targets, const std::array<double, 3>& offset, std::size_t t) {
  const Lanes d;
  return {hn::Add(hn::LoadU(d, targets.x + t), hn::Set(d, static_cast<float>(offset[0]))),
          hn::Add(hn::LoadU(d, targets.y + t), hn::Set(d, static_cast<float>(offset[1]))),
          hn::Add(hn::LoadU(d, targets.z + t), hn::Set(d, static_cast<float>(offset[2])))};
}

HWY_INLINE Vec weight(const Vec3s& target, const float* m, Vec delta2) {
  const Lanes d;
  const Vec x = hn::Sub(target.x, hn::Set(d, m[0])), y = hn::Sub(target.y, hn::Set(d, m[1])),
            z = hn::Sub(target.z, hn::Set(d, m[2]));
  return inverse_root_cubed(d, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::MulAdd(z, z, delta2))));
}

HWY_INLINE void add(Vec weight, const float* vector, Vec3s& sum) {
  const Lanes d;
  sum.x = hn::MulAdd(weight, hn::Set(d, vector[0]), sum.x);
  sum.y = hn::MulAdd(weight, hn::Set(d, vector[1]), sum.y);
  sum.z = hn::MulAdd(weight, hn::Set(d, vector[2]), sum.z);
}

HWY_INLINE void put(Vec values, std::size_t count, double* out) {
  const Lanes d;
  HWY_ALIGN float lanes[tree_lanes] = {};
  hn::Store(values, d, lanes);
  for (std::size_t i = 0; i < count; ++i) out[i] += static_cast<double>(lanes[i]);
}

void add_velocities(const TreeBodies<float>& targets, std::span<const NearSource> sources,
                    const std::array<double, 3>& offset, double delta_squared, double* out, std::size_t stride) {
  const Lanes d;
  const Vec delta2 = hn::Set(d, static_cast<float>(delta_squared)), none = hn::Zero(d);
  for (std::size_t t = 0; t < targets.size; t += hn::Lanes(d)) {
    const Vec3s at = load(targets, offset, t);
    Vec3s strength{none, none, none}, moment{none, none, none};
    for (const NearSource& source : sources) {
      const Vec w = weight(at, source.m, delta2);
      add(w, source.strength, strength);
      add(w, source.moment, moment);
    }
    const std::size_t count = HWY_MIN(hn::Lanes(d), targets.size - t);
    put(hn::NegMulAdd(strength.z, at.y, hn::MulSub(strength.y, at.z, moment.x)), count, out + t);
    put(hn::NegMulAdd(strength.x, at.z, hn::MulSub(strength.z, at.x, moment.y)), count, out + stride + t);
    put(hn::NegMulAdd(strength.y, at.x, hn::MulSub(strength.x, at.y, moment.z)), count, out + 2 * stride + t);
  }
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(add_velocities);

std::vector<NearSource> near_sources(const TreeBodies<float>& points) {
  std::vector<NearSource> sources(points.size);
  for (std::size_t i = 0; i < points.size; ++i) {
    const float x = points.x[i], y = points.y[i], z = points.z[i];
    const float gx = points.gx[i], gy = points.gy[i], gz = points.gz[i];
    sources[i] = {{x, y, z}, {gx, gy, gz}, {gy * z - gz * y, gz * x - gx * z, gx * y - gy * x}};
  }
  return sources;
}

bool are_near_enough(double apart, double target, double source, double delta) {
  // Nor must squares overflow.
  constexpr double most = 64, longest = 1e15;
  return apart + target <= std::min(longest, most * std::max(delta, apart - target - source));
}

void add_near_velocities(const TreeBodies<float>& targets, std::span<const NearSource> sources,
                         const std::array<double, 3>& offset, double delta_squared, double* out, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(add_velocities)(targets, sources, offset, delta_squared, out, stride);
}

}  // namespace foamsim
#endif  // HWY_ONCE
