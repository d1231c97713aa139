// Sums over vortices by a tree beside direct ones: a sheet of smooth circulation on a sphere, at its own points.
//
//   benchmark_tree_sum [--benchmark_filter=…]
//
// pairs: at the sources; terms: 1 all that the conservative dynamics want of a step (Ψ, u, B), 0 Ψ alone. velocities:
// what the vortex sheet's want, at half as many targets. digits: of the tolerance, 0 the direct sum, in the precision
// that the program chooses. error: the largest of 200 points' over the largest value, of what has the largest; bytes:
// what the sum has taken from the system besides the points.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/tree/tree.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

VortexSources sheet(std::size_t n) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  VortexSources sources;
  sources.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const double a = normal(random), b = normal(random);
    const Vec3 x = Vec3(a, b, normal(random)).normalized();
    sources.set(t, x, (x.cross(Vec3(1, 2, 3)) * std::sin(3 * x.x()) + Vec3(x.y(), -x.x(), 0)) / static_cast<double>(n));
  }
  return sources;
}

// Half of the mean edge of as many triangles.
double delta_of(std::size_t n) {
  return 0.5 * std::sqrt(4 * std::numbers::pi / static_cast<double>(n) * 4 / std::sqrt(3.0));
}

double largest_error(const VortexSources& s, double delta, const PairSums& sums) {
  constexpr std::size_t points = 200;
  std::array<double, 3> error{}, scale{};
  const auto note = [&](std::size_t what, const Vec3& exact, const std::vector<Vec3>& got, std::size_t t) {
    if (got.empty()) return;
    error[what] = std::max(error[what], (exact * std::numbers::inv_pi / 4 - got[t]).norm());
    scale[what] = std::max(scale[what], exact.norm() * std::numbers::inv_pi / 4);
  };
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t t = k * (s.size() / points);
    const Vec3 x(s.x[t], s.y[t], s.z[t]), own(s.gx[t], s.gy[t], s.gz[t]);
    Vec3 potential = Vec3::Zero(), velocity = Vec3::Zero(), force = Vec3::Zero();
    for (std::size_t i = 0; i < s.size(); ++i) {
      const Vec3 d = x - Vec3(s.x[i], s.y[i], s.z[i]), gamma(s.gx[i], s.gy[i], s.gz[i]);
      const double inverse = 1 / std::sqrt(d.squaredNorm() + delta * delta), weight = inverse * inverse * inverse;
      potential += inverse * gamma;
      velocity += weight * gamma.cross(d);
      force -= weight * own.dot(gamma) * d;
    }
    note(0, potential, sums.potential, t);
    note(1, velocity, sums.velocity, t);
    note(2, force, sums.force, t);
  }
  double largest = 0;
  for (std::size_t what = 0; what < 3; ++what)
    if (scale[what] > 0) largest = std::max(largest, error[what] / scale[what]);
  return largest;
}

double resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

TreeOptions of_digits(std::int64_t digits) {
  return {.tolerance = std::pow(10, -static_cast<double>(digits))};
}

void pairs(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(state.range(3)));
  const auto n = static_cast<std::size_t>(state.range(0));
  const PairTerms terms = state.range(1) == 1 ? PairTerms::all : PairTerms::potential;
  const VortexSources sources = sheet(n);
  const double delta = delta_of(n), before = resident_bytes();
  std::unique_ptr<PairSummation> summation;
  if (state.range(2) == 0)
    summation = std::make_unique<DirectPairSums>(Precision::automatic);
  else
    summation = std::make_unique<TreePairSums>(of_digits(state.range(2)), Precision::automatic);
  PairSums sums;
  for ([[maybe_unused]] auto _ : state) {
    summation->evaluate(sources, delta, terms, sums);
    benchmark::DoNotOptimize(sums.potential.data());
    benchmark::ClobberMemory();
  }
  state.counters["error"] = largest_error(sources, delta, sums);
  state.counters["bytes"] = resident_bytes() - before;
}

void velocities(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const VortexSources sources = sheet(n);
  std::vector<Vec3> targets, out(n / 2);
  for (std::size_t i = 0; i < n / 2; ++i) targets.emplace_back(sources.x[2 * i], sources.y[2 * i], sources.z[2 * i]);
  std::unique_ptr<BiotSavart> law;
  if (state.range(1) == 0)
    law = std::make_unique<DirectBiotSavart>();
  else
    law = std::make_unique<TreeBiotSavart>(of_digits(state.range(1)));
  for ([[maybe_unused]] auto _ : state) law->velocities(sources, targets, delta_of(n), out);
}

BENCHMARK(velocities)
    ->ArgNames({"sources", "digits"})
    ->ArgsProduct({{2'000, 4'000, 8'000, 16'000}, {0, 4, 6}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pairs)
    ->ArgNames({"sources", "terms", "digits", "threads"})
    ->ArgsProduct({{4'000, 8'000, 15'000, 32'000}, {0, 1}, {0, 4, 5, 6}, {1}})
    ->ArgsProduct({{100'000}, {0, 1}, {0, 4, 6}, {1}})
    ->ArgsProduct({{1'000'000}, {1}, {4, 5}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foamsim

BENCHMARK_MAIN();
