#include "Base/console/interrupt_guard.h"

#include <atomic>
#include <csignal>

namespace base {
namespace {

// A signal handler can reach nothing but a global flag.
std::atomic<bool> signal_seen{false};

void on_signal(int signal) {
  if (signal_seen.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_seen = false;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() {
  return signal_seen;
}

}  // namespace base
