#include "Base/console/generate_command.h"
#include "Base/console/termination.h"
#include "MultiTracker/app/commands.h"
#include "MultiTracker/app/manual.h"

int main(int argc, char** argv) {
  using namespace multitracker;
  base::report_terminations();
  app::Program program;
  program.name = base::program_name(argc, argv, "multitracker");
  program.command_line = base::command_text(program.name, argc, argv);
  base::CommandLine line(program.name, "moves a tracked surface of many regions by a flow", MULTITRACKER_VERSION);
  return base::run_command_line(line, argc, argv, [&program](base::CommandLine& commands) {
    app::add_run_command(commands.root(), program);
    app::add_scenes_command(commands.root(), program);
    app::add_study_command(commands.root(), program);
    base::add_generate_command(commands, app::manual);
  });
}
