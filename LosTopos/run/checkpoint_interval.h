#pragma once

#include <algorithm>

namespace lostopos::run {

/// When checkpoints are due by wall time: so many seconds after the last, and so late that they take at most 1% of a
/// run. All times are seconds since the start of the run.
class CheckpointInterval {
 public:
  /// `seconds`: from the end of a checkpoint to the next; 0: none is due.
  explicit CheckpointInterval(double seconds) : seconds_(seconds), next_(seconds) {}

  bool due(double now) const { return seconds_ > 0 && now >= next_; }
  /// One has been written from `begin` to `end`.
  void written(double begin, double end) {
    constexpr double least_share = 100;  // of a run, to what one takes
    next_ = end + std::max(seconds_, least_share * (end - begin));
  }

 private:
  double seconds_, next_;
};

}  // namespace lostopos::run
