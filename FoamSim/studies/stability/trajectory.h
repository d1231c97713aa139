#pragma once

#include <memory>
#include <string>
#include <vector>

#include "FoamSim/metrics/metrics.h"

namespace foamsim {

/// Something that moves a surface step by step: a simulation, or a prescribed motion.
class CaseMotion {
 public:
  CaseMotion() = default;
  CaseMotion(const CaseMotion&) = delete;
  CaseMotion& operator=(const CaseMotion&) = delete;
  virtual ~CaseMotion() = default;
  /// The surface as it stands, with nothing of a step.
  virtual Metrics start() const = 0;
  /// One step, measured. Throws base::Error when the surface cannot go on.
  virtual Metrics step() = 0;
  virtual const lostopos::SurfaceMesh& mesh() const = 0;
};

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
