#include "LosTopos/run/run_lock.h"

#include <chrono>
#include <string>
#include <system_error>
#include <thread>

#include "Base/error.h"

namespace lostopos::run {
namespace {

// One that has taken the lock just now signs it within moments.
std::string owner_of(const std::filesystem::path& file) {
  constexpr int most_looks = 50;
  std::string owner = base::signature_in(file);
  for (int look = 1; owner.empty() && look < most_looks; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    owner = base::signature_in(file);
  }
  return owner.empty() ? "another process" : owner;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& folder)
    : file_(folder / ".run.lock"), lock_(base::FileLock::take(file_)) {
  if (!lock_)
    throw base::InputError("a run is at work in " + folder.string() + ": " + owner_of(file_) +
                           "; give another --out, or wait until it has ended");
  lock_->sign();
}

RunLock::~RunLock() {
  std::error_code ignored;
  if (lock_ && lock_->descriptor() >= 0) std::filesystem::remove(file_, ignored);
}

}  // namespace lostopos::run
