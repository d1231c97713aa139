#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace foamsim::app {

/// Exit codes of the program.
enum ExitCode : int {
  exit_done = 0,
  exit_bad_input = 2,
  exit_simulation_failed = 3,
  exit_interrupted = 130,
};

/// What the program was called with, and what it will return.
struct Program {
  std::string command_line;
  int exit_code = exit_done;
};

/// Adds a command to the program; when it is given, its callback sets program.exit_code (or throws base::Error).
void add_run_command(CLI::App& app, Program& program);
void add_compare_command(CLI::App& app, Program& program);
void add_study_command(CLI::App& app, Program& program);
void add_reproduce_command(CLI::App& app, Program& program);
void add_render_command(CLI::App& app, Program& program);
void add_inspect_command(CLI::App& app, Program& program);
void add_convert_command(CLI::App& app, Program& program);
void add_list_commands(CLI::App& app, Program& program);

}  // namespace foamsim::app
