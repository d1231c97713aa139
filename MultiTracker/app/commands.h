#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace multitracker::app {

/// Exit codes of the program.
enum ExitCode : int {
  exit_done = 0,
  exit_bad_input = 2,
  exit_failed = 3,
  exit_interrupted = 130,
};

/// What the program was called with, and what it will return.
struct Program {
  std::string command_line;
  int exit_code = exit_done;
};

/// Adds a command to the program; when it is given, its callback sets program.exit_code (or throws base::Error).
void add_run_command(CLI::App& app, Program& program);
void add_scenes_command(CLI::App& app, Program& program);
void add_study_command(CLI::App& app, Program& program);

}  // namespace multitracker::app
