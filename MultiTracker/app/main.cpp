#include <csignal>
#include <cstdio>
#include <exception>

#include "Base/error.h"
#include "MultiTracker/app/commands.h"

namespace {

using namespace multitracker::app;

int run_program(int argc, char** argv) {
  CLI::App app{"multitracker: moves a tracked surface of many regions by a flow", "multitracker"};
  Program program;
  for (int i = 0; i < argc; ++i) program.command_line += (i == 0 ? "multitracker" : std::string(" ") + argv[i]);
  app.set_version_flag("--version", MULTITRACKER_VERSION);
  app.require_subcommand(1);
  add_run_command(app, program);
  add_scenes_command(app, program);
  add_study_command(app, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw base::InputError(std::string(error.what()) + " (see 'multitracker --help')");
  }
  return program.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that grows past its limit is reported by the failing write, not by the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run_program(argc, argv);
  } catch (const base::InputError& error) {
    std::fprintf(stderr, "multitracker: %s\n", error.what());
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "multitracker: %s\n", error.what());
    return exit_failed;
  }
}
