#pragma once

#include <functional>
#include <string>
#include <vector>

#include "Base/timing/stage_times.h"
#include "FoamSim/studies/accuracy/equilibrium_errors.h"

namespace foamsim {

struct AccuracyOptions {
  std::vector<std::string> areas{"naive", "constant-edge", "averaged"};  ///< strategies
  std::vector<long> sizes{12, 16, 24};                                   ///< N of the double bubble, 8 to 192
  std::vector<std::string> integrators{"euler", "rk4"};
  std::vector<double> steps_of_time{0.01, 0.02};  ///< dt, T, > 0
  double damping = 0.02;                          ///< d of the damping that brings the bubbles to rest, in (0, 1]
  double most_time = 12;                          ///< simulated time after which a run ends without rest, T, > 0
  bool remeshing = true;
};

/// Throws base::InputError for empty lists, unknown names and numbers out of range.
void validate(const AccuracyOptions& options);

/// What a row is of.
struct AccuracyCombination {
  long n = 0;  ///< of the double bubble
  std::string area, integrator;
  double dt = 0;  ///< T
};

/// Every combination of the lists, coarse ones first: a row each.
std::vector<AccuracyCombination> combinations(const AccuracyOptions& options);

/// One double bubble, from the report's start shape until it is at rest (RestDetector) or out of time.
struct AccuracyRow {
  std::string area;
  long n = 0;
  std::string integrator;
  double dt = 0;       ///< T
  std::string ended;   ///< "at rest", "not at rest" or "failed"
  std::string reason;  ///< of a failure
  long steps = 0;
  double time = 0;  ///< simulated, T
  std::size_t triangles = 0;
  double resolution = 0;                    ///< h̄, L
  std::optional<EquilibriumErrors> errors;  ///< none when the surface is no double bubble any more
  double volume_drift = 0;                  ///< largest |V/V0 − 1|
  double cpu_seconds = 0;                   ///< of all threads, without the measuring of errors
  double wall_seconds = 0;
  base::StageTimes stages;  ///< wall seconds: effects, velocity, move, remesh, geometry, rest (asking whether it is)
};

struct AccuracyHooks {
  std::function<void(const AccuracyRow&)> row;                              ///< after every run
  std::function<void(const std::string& label, double fraction)> progress;  ///< of the whole study, after every step
  std::function<bool()> interrupted;                                        ///< asked after every step
};

/// Every combination in turn. Ends early when interrupted, without the row of the run that was going on. Validates
/// first.
std::vector<AccuracyRow> study_accuracy(const AccuracyOptions& options, const AccuracyHooks& hooks = {});

}  // namespace foamsim
