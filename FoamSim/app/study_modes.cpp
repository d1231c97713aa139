#include <cstdio>
#include <memory>

#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/studies/modes/mode_csv.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct ModesArguments {
  std::string out = "out/modes";
  std::vector<long> modes{2, 3}, subdivisions{2, 3, 4};
  std::string dynamics = "vortex-sheet";
  bool force = false;
  int threads = 0;
};

void print_modes(const ModeConvergence& result) {
  for (const ModeRun& run : result.runs)
    std::printf("%5ld %10zu %9.4f %10.5f %10.5f %9.2f%% %9.3f%% %12.1e\n", run.options.mode, run.triangles, run.delta,
                run.omega, run.omega_theory, 100 * run.period_error(), 100 * run.energy_drift,
                run.peak_impulse / run.peak_impulse_scale);
  std::printf("%5ld %10s %9.4f %10.5f %10.5f %9.2f%%  order in delta:", result.runs.back().options.mode, "delta to 0",
              0.0, result.extrapolated_omega, result.runs.back().omega_theory, -100 * result.extrapolated_error());
  for (double order : result.observed_orders) std::printf(" %.2f", order);
  std::printf("\n");
}

int study_modes(const ModesArguments& arguments, const Program& program) {
  const fs::path out = arguments.out;
  require_new_study(out, "modes.csv", arguments.force);
  const ThreadLimit limit = thread_limit(arguments.threads);
  const InterruptGuard guard;
  struct Interrupted {};
  std::vector<ModeConvergence> results;
  std::printf("%5s %10s %9s %10s %10s %10s %10s %12s\n", "mode", "triangles", "delta", "omega", "theory", "period",
              "energy", "impulse");
  try {
    for (long mode : arguments.modes) {
      ModeOptions options;
      options.mode = mode;
      options.conservative = arguments.dynamics == "conservative";
      results.push_back(study_mode(options, arguments.subdivisions, [&](const ModeProgress&) {
        if (InterruptGuard::interrupted()) throw Interrupted();
      }));
      print_modes(results.back());
      std::fflush(stdout);
    }
  } catch (const Interrupted&) {
    if (results.empty()) return InterruptGuard::exit_code();
  }
  write_mode_csv(out / "modes.csv", results);
  write_mode_summary_csv(out / "modes_summary.csv", results);
  plot(program, "plot_modes.py", out);
  std::printf("output in %s\n", out.c_str());
  return InterruptGuard::interrupted() ? InterruptGuard::exit_code() : exit_done;
}

}  // namespace

void add_study_modes(base::Command& study, const Program& program) {
  base::Command& command = study.add_command("modes", "oscillation modes of a bubble against linear theory");
  auto arguments = std::make_shared<ModesArguments>();
  command.add({.name = "--modes", .target = &arguments->modes, .help = "modes to measure, separated by commas"});
  command.add({.name = "--subdivisions",
               .target = &arguments->subdivisions,
               .help = "subdivisions of the icosahedron, ascending, separated by commas"});
  command.add({.name = "--dynamics",
               .target = &arguments->dynamics,
               .help = "vortex-sheet or conservative",
               .names = {"vortex-sheet", "conservative"},
               .names_only = true});
  add_output(command, arguments->out, arguments->force, "the tables and the plot");
  add_threads(command, arguments->threads);
  command.set_action([arguments, &program] { return study_modes(*arguments, program); });
}

}  // namespace foamsim::app
