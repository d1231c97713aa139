#pragma once

#include <functional>
#include <string>

namespace multitracker {

/// How a child process ended.
struct ChildResult {
  bool finished = false;  ///< it returned its text; false: crashed, or used up its time
  std::string text;       ///< what it returned, or how it ended
  double cpu_seconds = 0;
  double peak_megabytes = 0;  ///< of memory in use
};

/// Runs `work` in a child process of its own, so that a crash, the memory and the time are its alone, and returns the
/// text that it returns. A child that takes more than `time_limit` seconds (wall) is ended, and so is one that is under
/// way when `interrupted` says so. The calling process must not have started threads. Throws base::FileError when
/// the system has no room for another process.
ChildResult run_in_child(const std::function<std::string()>& work, double time_limit,
                         const std::function<bool()>& interrupted = {});

}  // namespace multitracker
