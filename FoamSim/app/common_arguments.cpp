#include "FoamSim/app/common_arguments.h"

#include "FoamSim/scenes/methods.h"

namespace foamsim::app {

void add_threads(base::Command& command, int& threads) {
  command.add({.name = "--threads",
               .target = &threads,
               .help = "number of threads; 0: all cores; results do not depend on it"});
}

void add_quiet(base::Command& command, bool& quiet) {
  command.add({.name = "--quiet", .target = &quiet, .help = "print nothing but errors"});
}

void add_output(base::Command& command, std::string& out, bool& force, const std::string& what) {
  command.add(
      {.name = "--out", .target = &out, .help = "folder for " + what, .offers = base::Argument::Offers::folders});
  command.add({.name = "--force", .target = &force, .help = "replace what the folder holds"});
}

void add_areas(base::Command& command, std::vector<std::string>& areas, const Catalogue& catalogue) {
  command.add({.name = "--areas",
               .target = &areas,
               .help = "area strategies, or conservative, separated by commas",
               .names = method_names(catalogue)});
}

}  // namespace foamsim::app
