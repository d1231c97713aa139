#pragma once

#include <memory>
#include <string>

#include "Base/console/command.h"
#include "Base/console/program.h"
#include "FoamSim/scenes/catalogue.h"

namespace foamsim::app {

using base::exit_bad_input;
using base::exit_cannot_go_on;
using base::exit_done;
using base::exit_unfinished;

/// What the program was called with.
struct Program {
  std::string name;          ///< "foamsim", or that of another program with the same commands
  std::string command_line;  ///< as typed
  std::shared_ptr<const Catalogue> catalogue = built_in_catalogue();  ///< not null
};

/// Adds a command to the program. Its action returns the exit code, or throws base::Error. `program` has to outlive it.
void add_run_command(base::Command& root, const Program& program);
void add_compare_command(base::Command& root, const Program& program);
void add_sweep_command(base::Command& root, const Program& program);
void add_study_command(base::Command& root, const Program& program);
void add_reproduce_command(base::Command& root, const Program& program);
void add_render_command(base::Command& root, const Program& program);
void add_movie_command(base::Command& root, const Program& program);
void add_inspect_command(base::Command& root, const Program& program);
void add_stats_command(base::Command& root, const Program& program);
void add_convert_command(base::Command& root, const Program& program);
void add_export_web_command(base::Command& root, const Program& program);
void add_view_command(base::Command& root, const Program& program);
void add_list_commands(base::Command& root, const Program& program);

}  // namespace foamsim::app
