#pragma once

#include <functional>
#include <memory>

#include "FoamSim/studies/stability/trajectory.h"

namespace foamsim {

struct RecordOptions {
  long steps = 100;            ///< ≥ 1
  long audits = 10;            ///< whole-mesh audits, evenly spaced, the last one at the end; ≥ 1
  double most_seconds = 300;   ///< wall time after which the motion is stopped, asked after every step
  double most_energy = 2;      ///< times that of the first step: the motion has blown up and is stopped
  bool closed_surface = true;  ///< audits ask every region's boundary to be closed
};

struct RecordHooks {
  std::function<void(long steps_done)> progress;  ///< after every step
  std::function<bool()> interrupted;              ///< asked after every step
};

/// Makes the motion and lets it run for so many steps. Whatever goes wrong on the way, a surface that cannot be built
/// included, ends the trajectory with its error and is not thrown on.
Trajectory record(const std::function<std::unique_ptr<MeasuredMotion>()>& start, const RecordOptions& options,
                  const RecordHooks& hooks = {});

}  // namespace foamsim
