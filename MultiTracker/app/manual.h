#pragma once

#include "Base/console/manual_page.h"

namespace multitracker::app {

/// What multitracker's manual page says besides the commands: scenes with their option keys, exit codes.
base::Manual manual();

}  // namespace multitracker::app
