#pragma once

#include <functional>
#include <string>

#include "Base/console/command_line.h"
#include "Base/exit_code.h"

namespace base {

/// "foamsim" of "build/bin/foamsim"; `otherwise` where argv does not say.
std::string program_name(int argc, const char* const* argv, const std::string& otherwise);

/// The command line as it was typed, for the record of a run.
std::string command_text(const std::string& name, int argc, const char* const* argv);

/// What main returns: adds the commands to the program's line and runs it. Errors are one line on stderr and their exit
/// code; output that could not be written (a full disk) is an error, too.
int run_command_line(CommandLine& line, int argc, const char* const* argv,
                     const std::function<void(CommandLine&)>& add_commands);

}  // namespace base
