#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "FoamSim/app/commands.h"

namespace foamsim::app {

void add_study_modes(base::Command& study, const Program& program);
void add_study_accuracy(base::Command& study, const Program& program);
void add_study_stability(base::Command& study, const Program& program);

/// Makes the folder of a study whose table is `table`. Throws base::InputError when it holds one and `force` is not
/// given, or when it cannot be made.
void require_new_study(const std::filesystem::path& out, const std::string& table, bool force);

}  // namespace foamsim::app
