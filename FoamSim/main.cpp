#include "Base/console/program.h"
#include "Base/console/terminal.h"
#include "Base/console/termination.h"
#include "Base/error.h"
#include "FoamSim/app/run_program.h"
#include "FoamSim/launch/launch.h"

int main(int argc, char** argv) {
  base::report_terminations();
  std::unique_ptr<foamsim::Launch> launch;
  try {
    launch = foamsim::launch(argc, argv);
  } catch (const base::InputError& error) {
    base::print_error("foamsim", error.what());
    return base::exit_bad_input;
  }
  const auto catalogue = std::make_shared<foamsim::Catalogue>(*foamsim::built_in_catalogue());
  catalogue->sheet.ranks = launch->ranks();
  return launch->end(foamsim::run_program(argc, argv, catalogue));
}
