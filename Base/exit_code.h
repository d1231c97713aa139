#pragma once

namespace base {

/// What a program returns; 128 + N where signal N has ended it (130, 143, 129: InterruptGuard::exit_code()).
enum ExitCode : int {
  exit_done = 0,
  exit_bad_input = 2,     ///< what was given cannot be used
  exit_cannot_go_on = 3,  ///< a simulation failed
  exit_disk_full = 4,     ///< base::DiskError, or standard output that could not be written
  exit_unfinished = 5,    ///< of a sweep: some runs are still to come
};

}  // namespace base
