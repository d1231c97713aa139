#include "FoamSim/app/run_program.h"

#include "Base/console/generate_command.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/manual.h"
#include "FoamSim/version.h"

namespace foamsim {

int run_program(int argc, char** argv, std::shared_ptr<const Catalogue> catalogue) {
  app::Program program;
  program.catalogue = std::move(catalogue);
  program.name = base::program_name(argc, argv, "foamsim");
  program.command_line = base::command_text(program.name, argc, argv);
  base::CommandLine line(program.name, "soap films and foams by vortex sheets", std::string(version));
  return base::run_command_line(line, argc, argv, [&program](base::CommandLine& commands) {
    base::Command& root = commands.root();
    app::add_run_command(root, program);
    app::add_compare_command(root, program);
    app::add_study_command(root, program);
    app::add_reproduce_command(root, program);
    app::add_render_command(root, program);
    app::add_inspect_command(root, program);
    app::add_convert_command(root, program);
    app::add_list_commands(root, program);
    base::add_generate_command(commands, [&program] { return app::manual(*program.catalogue); });
  });
}

}  // namespace foamsim
