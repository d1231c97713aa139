#include "Base/console/interrupt_guard.h"

#include <atomic>

namespace base {
namespace {

// A signal handler can reach nothing but a global.
std::atomic<int> signal_seen{0};

void on_signal(int signal) {
  if (signal_seen.exchange(signal) != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_seen = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before_[i]);
    if (signals[i] == SIGHUP && before_[i].sa_handler == SIG_IGN) continue;
    sigaction(signals[i], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

bool InterruptGuard::interrupted() {
  return signal_seen != 0;
}

int InterruptGuard::exit_code() {
  return 128 + signal_seen;
}

}  // namespace base
