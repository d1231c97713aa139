#pragma once

#include "Base/console/manual_page.h"
#include "FoamSim/scenes/catalogue.h"

namespace foamsim::app {

/// What foamsim's manual page says besides the commands: scenes, effects, area strategies, option keys, exit codes,
/// files.
base::Manual manual(const Catalogue& catalogue);

}  // namespace foamsim::app
