#pragma once

namespace base {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a question that a run asks after every step, while it lives; a second signal
/// ends the program at once.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();
  static bool interrupted();
};

}  // namespace base
