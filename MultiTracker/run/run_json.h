#pragma once

#include <filesystem>
#include <string>

#include "MultiTracker/run/run.h"

namespace multitracker {

/// How a run was called for.
struct RunCall {
  std::string version, command, scene, mesh_file;
};

/// Writes run.json: version, command, scene with every option, threads, how the run ended, what was done and what it
/// cost. Throws base::FileError.
void write_run_json(const std::filesystem::path& file, const RunCall& call, const base::OptionSet& options,
                    const RunOutcome& outcome);

}  // namespace multitracker
