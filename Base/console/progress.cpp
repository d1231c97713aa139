#include "Base/console/progress.h"

#include <unistd.h>

#include <cstdio>

namespace base {
namespace {

constexpr double bar_interval = 0.1, line_interval = 5;  // seconds

}  // namespace

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void Progress::show(long step, double time, double fraction) {
  char detail[64];
  std::snprintf(detail, sizeof(detail), "step %ld, time %.3f", step, time);
  show(detail, fraction);
}

void Progress::show(const std::string& detail, double fraction) {
  if (quiet_) return;
  if (since_shown_.seconds() < (terminal_ ? bar_interval : line_interval)) return;
  since_shown_.restart();
  drawn_ = true;
  const double elapsed = since_start_.seconds();
  const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0;
  if (terminal_) {
    constexpr int width = 30;
    const int done = static_cast<int>(fraction * width);
    std::fprintf(stderr, "\r\033[K%s [%.*s%.*s] %s, %.0f s left", label_.c_str(), done,
                 "##############################", width - done, "..............................", detail.c_str(),
                 left);
    std::fflush(stderr);
  } else {
    std::fprintf(stderr, "%s: %s, %.0f%% done, about %.0f s left\n", label_.c_str(), detail.c_str(), 100 * fraction,
                 left);
  }
}

}  // namespace base
