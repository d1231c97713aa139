#pragma once

#include <filesystem>
#include <string>

#include "FoamSim/run/run.h"

namespace foamsim {

/// Writes run.json: version, command, scene with every option, seed, threads, machine, times, how the run ended.
void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunSettings& settings,
                    const RunOutcome& outcome);

}  // namespace foamsim
