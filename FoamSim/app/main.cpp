#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <new>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/version.h"

namespace {

using namespace foamsim::app;

// CLI11 only says that a word was not expected; name the command that was probably meant.
std::string first_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return {};
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::ranges::find(names, argv[1]) != names.end()) return {};
  const std::vector<std::string_view> known(names.begin(), names.end());
  return base::unknown_name_message("command", argv[1], known);
}

int run_program(int argc, char** argv) {
  CLI::App app{"foamsim: soap films and foams by vortex sheets", "foamsim"};
  Program program;
  for (int i = 0; i < argc; ++i) program.command_line += (i == 0 ? "foamsim" : std::string(" ") + argv[i]);
  app.set_version_flag("--version", std::string(foamsim::version));
  app.require_subcommand(1);
  add_run_command(app, program);
  add_compare_command(app, program);
  add_study_command(app, program);
  add_reproduce_command(app, program);
  add_render_command(app, program);
  add_inspect_command(app, program);
  add_convert_command(app, program);
  add_list_commands(app, program);
  if (const std::string message = first_unknown_command(app, argc, argv); !message.empty())
    throw base::InputError(message);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw base::InputError(std::string(error.what()) + " (see 'foamsim --help')");
  }
  return program.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("foamsim"));
  spdlog::set_pattern("%^foamsim: %v%$");
  // A file that grows past its limit is reported by the failing write, not by the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run_program(argc, argv);
  } catch (const base::InputError& error) {
    spdlog::error("{}", error.what());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    spdlog::error("out of memory: the mesh is too large for this machine");
    return exit_simulation_failed;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return exit_simulation_failed;
  }
}
