#include <cstdio>
#include <memory>

#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/statistics/run_statistics.h"

namespace foamsim::app {
namespace {

struct StatsArguments {
  std::string run, out;
  std::optional<long> step;
  bool no_plot = false, quiet = false;
};

void print_spread(const char* name, const Spread& spread) {
  if (spread.mean) std::printf("%-24s %.5g +- %.5g\n", name, *spread.mean, *spread.deviation);
}

void print_summary(const FrameStatistics& frame) {
  const FoamStatistics& foam = frame.foam;
  std::printf("step %ld, time %g: %zu bubbles, %zu of them inside; %zu films, %zu Plateau borders, %zu vertices\n",
              frame.step, frame.time, foam.bubbles.size(), foam.inner_bubbles(), foam.network.films.size(),
              foam.network.borders.size(), foam.network.vertices.size());
  print_spread("volume (L^3)", foam.volumes());
  print_spread("faces of a bubble", foam.faces());
  print_spread("  of one inside", foam.inner_faces());
  print_spread("edges of a film", foam.film_edges());
  print_spread("neighbours", foam.neighbours());
  print_spread("pressure/tension (1/L)", foam.pressures());
}

int stats(const StatsArguments& arguments, const Program& program) {
  RunStatisticsOptions options{.run = arguments.run, .step = arguments.step, .out = arguments.out};
  if (options.out.empty()) options.out = options.run / "stats";
  const InterruptGuard guard;
  Progress progress("stats", arguments.quiet);
  options.interrupted = [] { return InterruptGuard::interrupted(); };
  options.counted = [&progress](const FrameStatistics& frame, double fraction) {
    progress.show(frame.step, frame.time, fraction);
  };
  const FrameStatistics last = write_run_statistics(options);
  progress.clear();
  if (!arguments.quiet) print_summary(last);
  if (!arguments.no_plot) plot(program, "plot_stats.py", options.out);
  if (!arguments.quiet) std::printf("output in %s\n", options.out.c_str());
  return exit_done;
}

}  // namespace

void add_stats_command(base::Command& root, const Program& program) {
  using base::Argument;
  base::Command& command = root.add_command("stats", "count a run's bubbles, films and changes: tables and a plot");
  auto a = std::make_shared<StatsArguments>();
  command.add({.name = "run",
               .target = &a->run,
               .help = "the run's folder",
               .required = true,
               .offers = Argument::Offers::folders});
  command.add({.name = "--out",
               .target = &a->out,
               .help = "folder for the tables; by default stats in the run's",
               .offers = Argument::Offers::folders});
  command.add({.name = "--step", .target = &a->step, .help = "the frame of this step alone"});
  command.add({.name = "--no-plot", .target = &a->no_plot, .help = "tables only"});
  add_quiet(command, a->quiet);
  command.set_action([a, &program] { return stats(*a, program); });
}

}  // namespace foamsim::app
