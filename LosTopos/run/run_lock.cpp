#include "LosTopos/run/run_lock.h"

#include <system_error>

#include "Base/error.h"

namespace lostopos::run {

RunLock::RunLock(const std::filesystem::path& folder)
    : file_(folder / ".run.lock"), lock_(base::FileLock::take(file_)) {
  if (!lock_) {
    const std::string owner = base::signature_in(file_);
    throw base::InputError("a run is at work in " + folder.string() + ": " +
                           (owner.empty() ? "another process" : owner) +
                           "; give another --out, or wait until it has ended");
  }
  lock_->sign();
}

RunLock::~RunLock() {
  std::error_code ignored;
  if (lock_ && lock_->descriptor() >= 0) std::filesystem::remove(file_, ignored);
}

}  // namespace lostopos::run
