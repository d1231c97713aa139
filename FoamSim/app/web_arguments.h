#pragma once

#include <string>
#include <vector>

#include "Base/console/command.h"
#include "FoamSim/web/frame_pack.h"

namespace foamsim::app {

/// Arguments that export-web and view share: the run's folder, and what of its frames is sent.
void add_run_folder(base::Command& command, std::string& run);
void add_frame_options(base::Command& command, std::vector<std::string>& fields, std::string& precision);
/// Of --precision, which is one of its names.
web::Precision precision_of(const std::string& name);

}  // namespace foamsim::app
