#pragma once

#include <array>
#include <csignal>

namespace base {

/// Turns Ctrl-C (SIGINT), SIGTERM and SIGHUP into a question that a run asks between steps and within them (see
/// interruption.h), while it lives; a second signal ends the program at once. Where SIGHUP is ignored (nohup) it stays
/// so.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  /// Puts back what the signals did before.
  ~InterruptGuard();
  static bool interrupted();
  /// What a program that a signal ended returns: 128 + its number, so 130 (Ctrl-C), 143 (SIGTERM), 129 (SIGHUP).
  static int exit_code();

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_;
};

}  // namespace base
