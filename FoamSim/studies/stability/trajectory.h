#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "FoamSim/run/measured_motion.h"

namespace foamsim {

/// What physics allows a motion into which nothing is put: energy only falls, volumes and impulse stay.
struct PhysicsLimits {
  double energy_rise = 0.01;    ///< above the least energy so far, over the energy at the start
  double volume_drift = 0.02;   ///< largest |V/V0 − 1| of a bubble
  double impulse_drift = 0.05;  ///< largest |I − I0| over the largest Σ|2Γ̄ area|
};

/// Those that a method is held to: of the conservative one a fifth of the others' rise, a twentieth of their drift of
/// volumes, and 2% of impulse are asked.
PhysicsLimits physics_limits(std::string_view method);

/// What a motion did, as far as it came: what criteria judge.
struct Trajectory {
  std::string label;             ///< which of a case's runs it is
  std::vector<Metrics> samples;  ///< the start, then one a step (without times by stage)
  long steps_asked = 0;
  PhysicsLimits limits = {};                  ///< that it is held to
  std::string error;                          ///< why it could not go on; empty when it could
  std::string defect;                         ///< the first thing that an audit found wrong; empty when all were clean
  bool out_of_time = false;                   ///< stopped by its bound on wall time
  bool blown_up = false;                      ///< stopped by its bound on energy
  bool interrupted = false;                   ///< stopped by the user
  std::vector<lostopos::Vec3> end_positions;  ///< of the living vertices, in order, L
  double seconds = 0;                         ///< wall time

  long steps() const { return samples.empty() ? 0 : static_cast<long>(samples.size()) - 1; }
  bool complete() const { return error.empty() && steps() == steps_asked; }
};

}  // namespace foamsim
