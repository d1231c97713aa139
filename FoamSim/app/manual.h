#pragma once

#include "Base/console/manual_page.h"

namespace foamsim::app {

/// What foamsim's manual page says besides the commands: scenes, effects, area strategies, option keys, exit codes,
/// files.
base::Manual manual();

}  // namespace foamsim::app
