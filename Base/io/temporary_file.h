#pragma once

#include <filesystem>

namespace base {

/// The name under which a file is written before it gets its own: hidden, in the same folder, short enough for any file
/// system, free of other processes' names by the number of this one and of its own by that of the trial.
std::filesystem::path temporary_name(const std::filesystem::path& target, int trial);

/// Removes the files of such names that processes have left in a folder which have ended since: killed ones. Those of
/// other living processes stay. Numbers of processes are this machine's: where others write to the folder at this time,
/// its lock has to be held.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace base
