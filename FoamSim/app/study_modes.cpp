#include <cstdio>
#include <memory>

#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/studies/modes/mode_csv.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct Arguments {
  std::string out = "out/modes";
  std::vector<long> modes{2, 3}, subdivisions{2, 3, 4};
  bool quiet = false, force = false;
  int threads = 0;
};

void print(const ModeConvergence& result) {
  for (const ModeRun& run : result.runs)
    std::printf("%5ld %10zu %9.4f %10.5f %10.5f %9.2f%% %9.3f%% %12.1e\n", run.options.mode, run.triangles, run.delta,
                run.omega, run.omega_theory, 100 * run.period_error(), 100 * run.energy_drift,
                run.peak_impulse / run.peak_impulse_scale);
  std::printf("%5ld %10s %9.4f %10.5f %10.5f %9.2f%%  order in delta:", result.runs.back().options.mode, "delta to 0",
              0.0, result.extrapolated_omega, result.runs.back().omega_theory, -100 * result.extrapolated_error());
  for (double order : result.observed_orders) std::printf(" %.2f", order);
  std::printf("\n");
}

int study_modes(const Arguments& arguments) {
  const fs::path out = arguments.out;
  require_new_study(out, "modes.csv", arguments.force);
  const ThreadLimit limit(arguments.threads);
  const InterruptGuard guard;
  struct Interrupted {};
  std::vector<ModeConvergence> results;
  std::printf("%5s %10s %9s %10s %10s %10s %10s %12s\n", "mode", "triangles", "delta", "omega", "theory", "period",
              "energy", "impulse");
  try {
    for (long mode : arguments.modes) {
      ModeOptions options;
      options.mode = mode;
      results.push_back(study_mode(options, arguments.subdivisions, [&](const ModeProgress&) {
        if (InterruptGuard::interrupted()) throw Interrupted();
      }));
      print(results.back());
      std::fflush(stdout);
    }
  } catch (const Interrupted&) {
    if (results.empty()) return exit_interrupted;
  }
  write_mode_csv(out / "modes.csv", results);
  write_mode_summary_csv(out / "modes_summary.csv", results);
  plot_study("plot_modes.py", out);
  std::printf("output in %s\n", out.c_str());
  return InterruptGuard::interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

void add_study_modes(CLI::App& study, Program& program) {
  CLI::App* modes = study.add_subcommand("modes", "oscillation modes of a bubble against linear theory");
  auto arguments = std::make_shared<Arguments>();
  modes->add_option("--modes", arguments->modes, "modes to measure, separated by commas")->delimiter(',');
  modes->add_option("--subdivisions", arguments->subdivisions, "subdivisions of the icosahedron, ascending")
      ->delimiter(',');
  modes->add_option("--out", arguments->out, "folder for the output")->capture_default_str();
  modes->add_flag("--force", arguments->force, "replace a study that the folder holds");
  modes->add_option("--threads", arguments->threads, "number of threads (default: all cores)");
  modes->callback([arguments, &program] { program.exit_code = study_modes(*arguments); });
}

}  // namespace foamsim::app
