#pragma once

#include <utility>
#include <vector>

namespace multitracker {

/// How long the steps of a run are: all alike, or longer from certain times on.
class StepLengths {
 public:
  /// `dt`: T, > 0; a number stands for steps that are all alike.
  StepLengths(double dt) : dt_(dt) {}  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)

  /// Steps that begin at `time` (T) or later are `factor` times as long as those before. Times have to rise.
  StepLengths& grow_from(double time, double factor);

  /// The time at which a step begins, counted from 0; the length of that step. T.
  double time_of(long step) const { return at(step).first; }
  double of_step(long step) const { return at(step).second; }
  /// How many steps it takes to come to `time` (T), or past it.
  long steps_to(double time) const;

 private:
  std::pair<double, double> at(long step) const;

  double dt_;
  std::vector<std::pair<double, double>> stages_;
};

}  // namespace multitracker
