#include "MultiTracker/scenes/step_lengths.h"

#include <algorithm>
#include <cmath>

namespace multitracker {

StepLengths& StepLengths::grow_from(double time, double factor) {
  stages_.emplace_back(time, factor);
  return *this;
}

namespace {

// Steps of a length that make up a time, or more.
double steps_in(double time, double dt) {
  constexpr double rounding = 1e-9;  // of a step
  return std::ceil(time / dt - rounding);
}

}  // namespace

long StepLengths::steps_to(double time) const {
  double now = 0, dt = dt_, count = 0;
  for (const auto& [from, factor] : stages_) {
    if (!(from < time)) break;
    const double steps = steps_in(from - now, dt);
    count += steps;
    now += steps * dt;
    dt *= factor;
  }
  return static_cast<long>(count + std::max(0.0, steps_in(time - now, dt)));
}

// In closed form, so that a run that is taken up again has the same times to the bit.
std::pair<double, double> StepLengths::at(long step) const {
  double time = 0, dt = dt_;
  for (const auto& [from, factor] : stages_) {
    const double steps = steps_in(from - time, dt);
    if (!(static_cast<double>(step) >= steps)) break;
    time += steps * dt;
    step -= static_cast<long>(steps);
    dt *= factor;
  }
  return {time + static_cast<double>(step) * dt, dt};
}

}  // namespace multitracker
