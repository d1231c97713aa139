#include "FoamSim/sheet/velocity/direct_kernel.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "Base/error.h"

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/sheet/velocity/direct_kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Vec = hn::Vec<Doubles>;

// The sources are added up in runs of this many, and then the runs: keeps the rounding error that of about
// run + sources/run additions, and a run in the first-level cache.
constexpr std::size_t kRun = 256;

// Least δ², so that a target on a source gets 0 rather than 0/0 where δ = 0. No tolerance: it guards the range of a
// double (δ = 1e-100), and is lost in rounding beside the square of any distance from 1e-90 on.
constexpr double kLeastDeltaSquared = 0x1p-664;

// Add source t's γ × d / (|d|² + δ²)^{3/2}, d = x − m, for the targets x in the lanes.
//
// No MulAdd (nor a compiler that makes one: the project builds with -ffp-contract=off): two roundings are the same bits
// on every instruction set, and the square root and the division are the bottleneck anyway. The cross product is formed
// first because it can overlap with these.
HWY_INLINE void add_source(const VortexSources& s, std::size_t t, Vec x, Vec y, Vec z, Vec delta2, Vec& ux, Vec& uy,
                           Vec& uz) {
  const Doubles d;
  const Vec dx = hn::Sub(x, hn::Set(d, s.x[t]));
  const Vec dy = hn::Sub(y, hn::Set(d, s.y[t]));
  const Vec dz = hn::Sub(z, hn::Set(d, s.z[t]));
  const Vec gx = hn::Set(d, s.gx[t]);
  const Vec gy = hn::Set(d, s.gy[t]);
  const Vec gz = hn::Set(d, s.gz[t]);

  const Vec r2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Add(hn::Mul(dz, dz), delta2));
  const Vec weight = hn::Div(hn::Set(d, 1.0), hn::Mul(r2, hn::Sqrt(r2)));
  ux = hn::Add(ux, hn::Mul(weight, hn::Sub(hn::Mul(gy, dz), hn::Mul(gz, dy))));
  uy = hn::Add(uy, hn::Mul(weight, hn::Sub(hn::Mul(gz, dx), hn::Mul(gx, dz))));
  uz = hn::Add(uz, hn::Mul(weight, hn::Sub(hn::Mul(gx, dy), hn::Mul(gy, dx))));
}

// Velocities × 4π of one vector of targets; p: their x, y, z on entry, the result on return.
template <std::size_t N>
HWY_INLINE void sum_lanes(const VortexSources& sources, double delta2, double (&p)[3][N]) {
  const Doubles d;
  const Vec x = hn::Load(d, p[0]);
  const Vec y = hn::Load(d, p[1]);
  const Vec z = hn::Load(d, p[2]);
  const Vec delta2_lanes = hn::Set(d, delta2);
  Vec ux = hn::Zero(d);
  Vec uy = ux;
  Vec uz = ux;
  for (std::size_t first = 0; first < sources.size(); first += kRun) {
    const std::size_t end = std::min(first + kRun, sources.size());
    Vec run_x = hn::Zero(d);
    Vec run_y = run_x;
    Vec run_z = run_x;
    for (std::size_t t = first; t < end; ++t) add_source(sources, t, x, y, z, delta2_lanes, run_x, run_y, run_z);
    ux = hn::Add(ux, run_x);
    uy = hn::Add(uy, run_y);
    uz = hn::Add(uz, run_z);
  }
  hn::Store(ux, d, p[0]);
  hn::Store(uy, d, p[1]);
  hn::Store(uz, d, p[2]);
}

void sum(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
         std::span<lostopos::Vec3> out) {
  const Doubles d;
  const double delta2 = std::max(delta * delta, kLeastDeltaSquared);
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN double p[3][hn::MaxLanes(Doubles())];
  for (std::size_t first = 0; first < targets.size(); first += lanes) {
    const std::size_t used = std::min(lanes, targets.size() - first);
    for (std::size_t lane = 0; lane < lanes; ++lane) {  // spare lanes repeat the last target
      const lostopos::Vec3& target = targets[first + std::min(lane, used - 1)];
      for (int axis = 0; axis < 3; ++axis) p[axis][lane] = target[axis];
    }
    sum_lanes(sources, delta2, p);
    constexpr double scale = std::numbers::inv_pi / 4;
    for (std::size_t lane = 0; lane < used; ++lane) {
      out[first + lane] = {scale * p[0][lane], scale * p[1][lane], scale * p[2][lane]};
    }
  }
}

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(sum);
HWY_EXPORT(target_name);

void sum_biot_savart(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                     std::span<lostopos::Vec3> out) {
  HWY_DYNAMIC_DISPATCH(sum)(sources, targets, delta, out);
}

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

void use_simd_target(std::string_view name) {
  std::string offered;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name == hwy::TargetName(target)) {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      return;
    }
    offered += (offered.empty() ? "" : ", ") + std::string(hwy::TargetName(target));
  }
  throw base::InputError("there is no instruction set '" + std::string(name) + "' on this machine; it has " + offered);
}

const char* biot_savart_simd_target() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace foamsim
#endif  // HWY_ONCE
