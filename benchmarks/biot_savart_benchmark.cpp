// Rate of the direct Biot–Savart sum, at the size of the report's double bubbles N = 48 and 96 (targets: vertices,
// sources: triangles), beside a plain scalar loop.
//
//   benchmark_biot_savart [--benchmark_filter=…] [--benchmark_repetitions=5 --benchmark_report_aggregates_only=true]
//
// interactions: pairs a second of wall time. per_cpu_second: pairs a second of CPU time of one thread; times the
// threads it is what `interactions` would be on a machine that nobody else uses.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/pair_sums.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

constexpr double kDelta = 0.05;

struct Problem {
  VortexSources sources;
  std::vector<Vec3> targets;
  std::vector<Vec3> velocities;
};

Problem unit_sphere(std::size_t targets, std::size_t sources) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    const double x = normal(random);
    const double y = normal(random);
    return Vec3(x, y, normal(random)).normalized();
  };
  Problem problem;
  for (std::size_t i = 0; i < targets; ++i) problem.targets.push_back(direction());
  problem.sources.resize(sources);
  for (std::size_t t = 0; t < sources; ++t) {
    const Vec3 point = direction();
    problem.sources.set(t, point, direction() / static_cast<double>(sources));
  }
  problem.velocities.resize(targets);
  return problem;
}

Vec3 scalar_velocity(const VortexSources& s, const Vec3& x) {
  double ux = 0;
  double uy = 0;
  double uz = 0;
  for (std::size_t t = 0; t < s.size(); ++t) {
    const double dx = x.x() - s.x[t];
    const double dy = x.y() - s.y[t];
    const double dz = x.z() - s.z[t];
    const double r2 = dx * dx + dy * dy + dz * dz + kDelta * kDelta;
    const double weight = 1 / (r2 * std::sqrt(r2));
    ux += weight * (s.gy[t] * dz - s.gz[t] * dy);
    uy += weight * (s.gz[t] * dx - s.gx[t] * dz);
    uz += weight * (s.gx[t] * dy - s.gy[t] * dx);
  }
  return std::numbers::inv_pi / 4 * Vec3(ux, uy, uz);
}

template <class Sum>
void measure(benchmark::State& state, Sum sum) {
  Problem problem = unit_sphere(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
  sum(problem);  // wakes the threads
  const std::clock_t start = std::clock();
  for ([[maybe_unused]] auto _ : state) {
    sum(problem);
    benchmark::DoNotOptimize(problem.velocities.data());
    benchmark::ClobberMemory();
  }
  const double cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double pairs = static_cast<double>(state.range(0)) * static_cast<double>(state.range(1)) *
                       static_cast<double>(state.iterations());
  state.counters["interactions"] = benchmark::Counter(pairs, benchmark::Counter::kIsRate);
  state.counters["per_cpu_second"] = pairs / cpu_seconds;
}

void direct(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(state.range(2)));
  const DirectBiotSavart summation;
  measure(state, [&](Problem& p) { summation.velocities(p.sources, p.targets, kDelta, p.velocities); });
}

void scalar_loop(benchmark::State& state) {
  measure(state, [](Problem& p) {
    for (std::size_t i = 0; i < p.targets.size(); ++i) p.velocities[i] = scalar_velocity(p.sources, p.targets[i]);
  });
}

// The conservative scheme's sums: every pair once for both its members. "interactions" counts it once.
void pair_sums(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(state.range(2)));
  const auto n = static_cast<std::size_t>(state.range(0));
  const Problem problem = unit_sphere(0, n);
  DirectPairSums direct_sums;
  PairSums sums;
  const PairTerms terms = state.range(1) == 1 ? PairTerms::all : PairTerms::potential;
  for ([[maybe_unused]] auto _ : state) {
    direct_sums.evaluate(problem.sources, kDelta, terms, sums);
    benchmark::DoNotOptimize(sums.potential.data());
    benchmark::ClobberMemory();
  }
  state.counters["interactions"] =
      benchmark::Counter(static_cast<double>(n) * static_cast<double>(n) / 2 * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

BENCHMARK(pair_sums)
    ->ArgNames({"triangles", "all_terms", "threads"})
    ->ArgsProduct({{8'016}, {0, 1}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK(direct)
    ->ArgNames({"targets", "sources", "threads"})
    ->ArgsProduct({{4'010}, {8'016}, {1, 2}})
    ->ArgsProduct({{16'082}, {32'160}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK(scalar_loop)
    ->ArgNames({"targets", "sources"})
    ->Args({4'010, 8'016})
    ->Args({16'082, 32'160})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace
}  // namespace foamsim

int main(int argc, char** argv) {
  benchmark::AddCustomContext("CPU model", foamsim::cpu_model());
  benchmark::AddCustomContext("SIMD target", std::string(foamsim::DirectBiotSavart::simd_target()));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
