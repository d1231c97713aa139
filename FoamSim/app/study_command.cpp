#include <cstdio>

#include "Base/error.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/study_commands.h"

namespace foamsim::app {

namespace fs = std::filesystem;

void require_new_study(const fs::path& out, const std::string& table, bool force) {
  if (!force && fs::exists(out / table))
    throw base::InputError(out.string() + " already holds a study; give another --out, or --force to replace it");
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw base::FileError("cannot make the folder " + out.string() + ": " + error.message());
}

void plot_study(const std::string& script, const fs::path& out) {
  if (!run_plot_script(script, out))
    std::fprintf(stderr, "foamsim: no plot: it needs python3 with matplotlib and plots/%s\n", script.c_str());
}

void add_study_command(CLI::App& app, Program& program) {
  CLI::App* study = app.add_subcommand("study", "measure the method: against theory, its accuracy and its stability");
  study->require_subcommand(1);
  add_study_modes(*study, program);
  add_study_accuracy(*study, program);
  add_study_stability(*study, program);
}

}  // namespace foamsim::app
