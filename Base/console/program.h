#pragma once

#include <functional>
#include <string>

#include "Base/console/command_line.h"

namespace base {

/// What a program returns, apart from InterruptGuard::exit_code().
enum ExitCode : int {
  exit_done = 0,
  exit_bad_input = 2,
  exit_cannot_go_on = 3,
};

/// "foamsim" of "build/bin/foamsim"; `otherwise` where argv does not say.
std::string program_name(int argc, const char* const* argv, const std::string& otherwise);

/// The command line as it was typed, for the record of a run.
std::string command_text(const std::string& name, int argc, const char* const* argv);

/// What main returns: adds the commands to the program's line and runs it. Errors are one line on stderr and their exit
/// code; output that could not be written (a full disk) is an error, too.
int run_command_line(CommandLine& line, int argc, const char* const* argv,
                     const std::function<void(CommandLine&)>& add_commands);

}  // namespace base
