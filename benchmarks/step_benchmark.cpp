// A whole step of a double bubble, as 'foamsim run' makes it: effects, velocity, move, geometry and metrics.
#include <benchmark/benchmark.h>

#include "Base/timing/stopwatch.h"
#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/scene.h"

namespace {

void double_bubble_step(benchmark::State& state) {
  foamsim::Scene scene = foamsim::built_in_scene("doublebubble");
  scene.options.set("n", state.range(0), "benchmark");
  foamsim::Simulation simulation = foamsim::make_simulation(scene);
  const auto volumes = lostopos::region_volumes(simulation.mesh());
  base::StageTimes times;
  for (auto _ : state) {
    foamsim::StepReport report = simulation.step();
    {
      const base::TimedScope timed(report.times, "metrics");
      benchmark::DoNotOptimize(foamsim::measure(simulation, report, volumes));
    }
    times.add(report.times);
  }
  state.counters["triangles"] = static_cast<double>(simulation.mesh().triangle_count());
  for (const auto& [stage, seconds] : times.stages()) state.counters[stage + "_share"] = seconds / times.total();
}

BENCHMARK(double_bubble_step)->Arg(16)->Arg(24)->Arg(48)->Arg(96)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
