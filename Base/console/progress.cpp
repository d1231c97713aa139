#include "Base/console/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "Base/console/terminal.h"

namespace base {
namespace {

constexpr double bar_interval = 0.1, line_interval = 5;  // seconds

std::string left_text(double seconds) {
  char text[32] = "";
  if (seconds >= 0) std::snprintf(text, sizeof(text), ", %.0f s left", seconds);
  return text;
}

}  // namespace

std::string progress_line(const std::string& label, const std::string& detail, double fraction, double seconds_left,
                          int width) {
  constexpr int widest = 30, narrowest = 5, brackets = 4;  // " [" and "] "
  const std::string left = left_text(seconds_left);
  const int room = width - static_cast<int>(label.size() + detail.size() + left.size()) - brackets;
  if (room < narrowest) {
    std::string text = label + " " + detail + left;
    if (width >= 0 && static_cast<int>(text.size()) > width) text = label + left;
    return text.substr(0, static_cast<std::size_t>(std::max(width, 0)));
  }
  const int columns = std::min(room, widest);
  const int done = std::clamp(static_cast<int>(fraction * columns), 0, columns);
  return label + " [" + std::string(static_cast<std::size_t>(done), '#') +
         std::string(static_cast<std::size_t>(columns - done), '.') + "] " + detail + left;
}

double TimeLeft::estimate(double fraction, double seconds) {
  if (fraction < last_fraction_) {
    first_fraction_ = fraction;
    first_seconds_ = seconds;
  }
  last_fraction_ = fraction;
  if (fraction <= first_fraction_) return -1;
  return (seconds - first_seconds_) * (1 - fraction) / (fraction - first_fraction_);
}

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
  const double left = time_left_.estimate(fraction, since_start_.seconds());
  if (since_shown_.seconds() < (terminal_ ? bar_interval : line_interval)) return;
  since_shown_.restart();
  drawn_ = true;
  if (terminal_) {
    // One column less: a full line makes some terminals go on to the next.
    const std::string line = progress_line(label_, detail, fraction, left, terminal_width(STDERR_FILENO) - 1);
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
  } else {
    std::fprintf(stderr, "%s: %s, %.0f%% done%s\n", label_.c_str(), detail.c_str(), 100 * fraction,
                 left_text(left).c_str());
  }
}

}  // namespace base
