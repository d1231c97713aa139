#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/collision/safe_move.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"

namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

// A smooth swirl of at most 0.05 h̄ in a step: nothing collides.
std::vector<Vec3> quiet_step(const SurfaceMesh& mesh, double h) {
  std::vector<Vec3> predicted(mesh.positions().begin(), mesh.positions().end());
  for (Vec3& x : predicted) {
    const Vec3 u(std::sin(2 * x[1]), std::sin(2 * x[2] + 1), std::sin(2 * x[0] + 2));
    x += 0.05 * h / std::sqrt(3.0) * u;
  }
  return predicted;
}

// One core: what a step takes of the whole time, and of the parts.
void run(benchmark::State& state, const SurfaceMesh& original) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  const double h = mean_edge_length(original);
  lostopos::MoveOptions options;
  options.proximity_epsilon = 1e-4 * h;
  lostopos::MoveStatistics sum;
  SurfaceMesh mesh = original.clone();
  const std::vector<Vec3> there = quiet_step(mesh, h);
  const std::vector<Vec3> back(mesh.positions().begin(), mesh.positions().end());
  bool forth = true;
  for (auto _ : state) {
    sum += move_safely(mesh, forth ? there : back, {}, options).statistics;
    forth = !forth;
  }
  const double triangles = static_cast<double>(mesh.triangle_count());
  const double all = static_cast<double>(state.iterations()) * triangles;
  state.counters["triangles"] = triangles;
  state.counters["us_per_triangle"] =
      benchmark::Counter(all * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["broad_us"] = 1e6 * sum.broad_phase_seconds / all;
  state.counters["ccd_us"] = 1e6 * sum.ccd_seconds / all;
  state.counters["pairs"] = static_cast<double>(sum.pairs) / all;
  state.counters["collisions"] = static_cast<double>(sum.collisions);
}

void double_bubble(benchmark::State& state) {
  run(state, foamsim::double_bubble(state.range(0)));
}
BENCHMARK(double_bubble)->Arg(27)->Arg(54)->Arg(107)->Arg(170)->Unit(benchmark::kMillisecond);

void icosphere(benchmark::State& state) {
  run(state, lostopos::icosphere(state.range(0)));
}
BENCHMARK(icosphere)->DenseRange(3, 6)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
