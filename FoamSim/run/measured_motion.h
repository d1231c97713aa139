#pragma once

#include "FoamSim/metrics/metrics.h"
#include "LosTopos/run/motion.h"

namespace foamsim {

/// A motion whose surface is measured as a film's is.
class MeasuredMotion : public lostopos::run::Motion {
 public:
  /// After the last step; at the start: of the surface, with nothing of a step.
  virtual const Metrics& metrics() const = 0;
};

}  // namespace foamsim
