#include "FoamSim/app/session.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

namespace foamsim::app {
namespace {

// A signal handler can reach nothing but a global flag.
std::atomic<bool> signal_seen{false};

void on_signal(int signal) {
  if (signal_seen.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

constexpr double bar_interval = 0.1, line_interval = 5;  // seconds

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

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void Progress::show(const Metrics& metrics, double fraction) {
  if (quiet_) return;
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < (terminal_ ? bar_interval : line_interval)) return;
  last_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0;
  if (terminal_) {
    constexpr int width = 30;
    const int done = static_cast<int>(fraction * width);
    std::fprintf(stderr, "\r\033[K%s [%.*s%.*s] step %ld  t %.3f  %.0f s left", label_.c_str(), done,
                 "##############################", width - done, "..............................", metrics.step,
                 metrics.time, left);
    std::fflush(stderr);
  } else {
    std::fprintf(stderr, "%s: step %ld, time %.3f, %.0f%% done, about %.0f s left\n", label_.c_str(), metrics.step,
                 metrics.time, 100 * fraction, left);
  }
}

RunHooks hooks_for(Progress& progress) {
  return {[&progress](const Metrics& metrics, double fraction) { progress.show(metrics, fraction); },
          [] { return InterruptGuard::interrupted(); }};
}

}  // namespace foamsim::app
