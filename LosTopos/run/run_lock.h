#pragma once

#include <filesystem>
#include <optional>

#include "Base/io/file_lock.h"

namespace lostopos::run {

/// The right to write into a run's folder, which one run has at a time: a lock on the file .run.lock there, which says
/// who holds it and is removed at the end. One that a killed process has left locks nobody out.
class RunLock {
 public:
  /// Throws base::InputError, naming process and machine, when another run has it; base::FileError where the folder
  /// cannot be written to.
  explicit RunLock(const std::filesystem::path& folder);
  RunLock(RunLock&&) noexcept = default;
  RunLock& operator=(RunLock&&) = delete;
  ~RunLock();

 private:
  std::filesystem::path file_;
  std::optional<base::FileLock> lock_;
};

}  // namespace lostopos::run
