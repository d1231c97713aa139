#pragma once

#include <string>
#include <vector>

#include "FoamSim/run/measured_motion.h"

namespace foamsim {

/// What a motion did, as far as it came: what criteria judge.
struct Trajectory {
  std::string label;             ///< which of a case's runs it is
  std::vector<Metrics> samples;  ///< the start, then one a step (without times by stage)
  long steps_asked = 0;
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
