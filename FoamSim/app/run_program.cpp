#include "FoamSim/app/run_program.h"

#include <string_view>

#include "Base/console/generate_command.h"
#include "Base/console/terminal.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/manual.h"
#include "FoamSim/version.h"

namespace foamsim {

namespace {

// What other commands do is not shared out, and each process would do all of it.
bool is_for_one_process(const Catalogue& catalogue, int argc, char** argv) {
  return catalogue.sheet.ranks->size() > 1 && (argc < 2 || std::string_view(argv[1]) != "run");
}

}  // namespace

int run_program(int argc, char** argv, std::shared_ptr<const Catalogue> catalogue) {
  app::Program program;
  program.catalogue = std::move(catalogue);
  program.name = base::program_name(argc, argv, "foamsim");
  program.command_line = base::command_text(program.name, argc, argv);
  if (is_for_one_process(*program.catalogue, argc, argv)) {
    base::print_error(program.name, "several processes share out the command 'run' alone; start the others once");
    return base::exit_bad_input;
  }
  base::CommandLine line(program.name, "soap films and foams by vortex sheets", std::string(version));
  return base::run_command_line(line, argc, argv, [&program](base::CommandLine& commands) {
    base::Command& root = commands.root();
    app::add_run_command(root, program);
    app::add_compare_command(root, program);
    app::add_sweep_command(root, program);
    app::add_study_command(root, program);
    app::add_reproduce_command(root, program);
    app::add_render_command(root, program);
    app::add_movie_command(root, program);
    app::add_inspect_command(root, program);
    app::add_stats_command(root, program);
    app::add_convert_command(root, program);
    app::add_export_web_command(root, program);
    app::add_view_command(root, program);
    app::add_list_commands(root, program);
    base::add_generate_command(commands, [&program] { return app::manual(*program.catalogue); });
  });
}

}  // namespace foamsim
