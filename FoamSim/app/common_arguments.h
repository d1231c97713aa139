#pragma once

#include <string>
#include <vector>

#include "Base/console/command.h"
#include "FoamSim/scenes/catalogue.h"

namespace foamsim::app {

/// Arguments that several commands have: each is put where its name says.
void add_threads(base::Command& command, int& threads);
void add_quiet(base::Command& command, bool& quiet);
/// --out and --force of a command that makes `what` ("accuracy.csv and the plot").
void add_output(base::Command& command, std::string& out, bool& force, const std::string& what);
void add_areas(base::Command& command, std::vector<std::string>& areas, const Catalogue& catalogue);

}  // namespace foamsim::app
