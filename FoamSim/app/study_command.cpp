#include "Base/error.h"
#include "Base/io/write_error.h"
#include "FoamSim/app/study_commands.h"

namespace foamsim::app {

namespace fs = std::filesystem;

void require_new_study(const fs::path& out, const std::string& table, bool force) {
  if (!force && fs::exists(out / table))
    throw base::InputError(out.string() + " already holds a study; give another --out, or --force to replace it");
  base::make_folder(out);
}

void add_study_command(base::Command& root, const Program& program) {
  base::Command& study =
      root.add_command("study", "measure the method: against theory, its accuracy and its stability");
  add_study_modes(study, program);
  add_study_accuracy(study, program);
  add_study_stability(study, program);
}

}  // namespace foamsim::app
