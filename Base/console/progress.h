#pragma once

#include <string>

#include "Base/timing/stopwatch.h"

namespace base {

/// How far something is, in one line of at most `width` columns: "LABEL [####......] DETAIL, 12 s left". What has no
/// place is left out: first the bar is shortened, then it goes, then the detail is cut. `seconds_left` < 0: not known.
std::string progress_line(const std::string& label, const std::string& detail, double fraction, double seconds_left,
                          int width);

/// How long something still takes, by how far it has come since it was first looked at: a run that is resumed starts
/// amid its whole, and one that falls back, as to another stage, counts from there.
class TimeLeft {
 public:
  /// Seconds; < 0: not known yet. `fraction`: of the whole that is done at `seconds` of any clock.
  double estimate(double fraction, double seconds);

 private:
  double first_fraction_ = 2, first_seconds_ = 0;  // beyond any fraction: nothing has been seen
  double last_fraction_ = 2;
};

/// Shows how far a run is: a bar on a terminal, a line every few seconds elsewhere, nothing when quiet.
class Progress {
 public:
  Progress(std::string label, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  /// `fraction`: of the whole that is done.
  void show(long step, double time, double fraction);
  /// `detail`: what is being done now.
  void show(const std::string& detail, double fraction);
  /// Another label, the same clock.
  void relabel(std::string label) { label_ = std::move(label); }
  /// Takes a bar off the terminal, so that other lines can be written.
  void clear();

 private:
  std::string label_;
  bool quiet_, terminal_, drawn_ = false;
  Stopwatch since_start_, since_shown_;
  TimeLeft time_left_;
};

}  // namespace base
