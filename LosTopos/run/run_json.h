#pragma once

#include <filesystem>
#include <string>

#include "LosTopos/run/run.h"

namespace lostopos::run {

/// Writes run.json: the description (version, command, scene with every option, ...), threads, machine, how the run
/// ended, how far it came, what was done and refused by reason, what it took by stage, and the motion's summary. Throws
/// base::FileError, base::DiskError.
void write_run_json(const std::filesystem::path& file, const Output& output, const Motion& motion,
                    const std::string& ended, const Outcome& outcome);

}  // namespace lostopos::run
