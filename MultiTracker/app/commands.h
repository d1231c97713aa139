#pragma once

#include <string>
#include <vector>

#include "Base/console/command.h"
#include "Base/console/program.h"

namespace multitracker::app {

using base::exit_bad_input;
using base::exit_cannot_go_on;
using base::exit_done;

/// What the program was called with.
struct Program {
  std::string name;          ///< "multitracker"
  std::string command_line;  ///< as typed
};

/// Adds a command to the program. Its action returns the exit code, or throws base::Error. `program` has to outlive it.
void add_run_command(base::Command& root, const Program& program);
void add_scenes_command(base::Command& root, const Program& program);
void add_study_command(base::Command& root, const Program& program);

/// The scenes there are, for completion.
std::vector<std::string> scene_names();

}  // namespace multitracker::app
