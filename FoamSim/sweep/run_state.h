#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace foamsim::sweep {

/// Where a run is. An interrupted one goes on from its checkpoint, or from its start where it has none.
enum class Status { pending, queued, running, interrupted, finished, failed };
/// "pending", "queued", ...
const char* name(Status status);

/// What a run's folder says.
struct RunState {
  Status status = Status::pending;
  std::optional<long> exit_code;  ///< none: nobody saw it end
  std::string message;
};

/// What was seen of the last attempt, in the folder's state.json.
struct Attempt {
  std::optional<long> exit_code;  ///< none: it has not ended, or nobody saw it
  int signal = 0;                 ///< that ended it; 0: none
  std::string message;
};

/// Nothing where there was no attempt. A damaged file counts as an attempt whose end nobody saw.
std::optional<Attempt> read_attempt(const std::filesystem::path& run_folder);
/// Throws base::FileError.
void write_attempt(const std::filesystem::path& run_folder, const Attempt& attempt);

/// What the files of a folder say in which no process works.
RunState recorded_state(const std::filesystem::path& run_folder);
/// The same, or `running` where a process holds the lock.
RunState look_at(const std::filesystem::path& run_folder);

/// The file whose lock a run's process holds.
std::filesystem::path lock_file(const std::filesystem::path& run_folder);

}  // namespace foamsim::sweep
