#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "FoamSim/app/commands.h"

namespace foamsim::app {

void add_study_modes(CLI::App& study, Program& program);
void add_study_accuracy(CLI::App& study, Program& program);
void add_study_stability(CLI::App& study, Program& program);

/// Makes the folder of a study whose table is `table`. Throws base::InputError when it holds one and `force` is not
/// given, or when it cannot be made.
void require_new_study(const std::filesystem::path& out, const std::string& table, bool force);

/// Draws the study's plot, or says on stderr why there is none.
void plot_study(const std::string& script, const std::filesystem::path& out);

}  // namespace foamsim::app
