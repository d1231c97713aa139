#pragma once

#include <optional>
#include <span>
#include <string>

#include "FoamSim/studies/stability/trajectory.h"

namespace foamsim {

/// How far a trajectory went from what physics allows.
struct PhysicsFigures {
  double energy_rise = 0, volume_drift = 0, impulse_drift = 0;
  double energy_excess = 0;  ///< of the largest energy over that of the first step, relative to it; ≥ 0
  bool finite = true;        ///< energy, area, impulse, centroid and volumes at every step
};

/// Energies are taken from the first step on: the start's sample knows no kinetic energy.
PhysicsFigures physics_figures(const Trajectory& trajectory);

struct Verdict {
  bool passed = false;
  std::string reason;       ///< why not; empty when passed
  std::string figure_name;  ///< what `figure` is; empty when the case has none
  std::optional<double> figure;
};

/// A verdict that is passed so far, and loses that by the first condition that does not hold.
class Judgement {
 public:
  /// Notes `reason` unless `condition` holds or something was noted before.
  Judgement& require(bool condition, const std::string& reason);
  /// The motion went all its way, every audit was clean, and everything stayed finite.
  Judgement& require_sound(const Trajectory& trajectory);
  /// Sound, and within the limits of physics.
  Judgement& require_physics(const Trajectory& trajectory);
  /// Sound, and neither energy above that of the first step by more than its limit of a rise, nor volumes lost:
  /// what an unstable step breaks first, while a strategy's own error of energy, the same at every dt, does not.
  Judgement& require_stable(const Trajectory& trajectory);
  Judgement& set_figure(std::string name, std::optional<double> value);
  Verdict verdict() const { return verdict_; }

 private:
  Verdict verdict_{.passed = true, .reason = "", .figure_name = "", .figure = {}};
};

/// The first trajectory within the usual limits of physics: the whole criterion of many cases.
Verdict within_physics(std::span<const Trajectory> trajectories);

/// Largest relative difference of two trajectories of the same case: of every step's measures and of the vertices at
/// the end. `b` is the motion `a` with lengths multiplied by `scale` and then moved by `offset` (L). Measures with a
/// unit are taken over their own size, centroids and positions over the square root of the area, impulses over Σ|2Γ̄
/// area|, angles over 1°. Infinite when counts of steps or elements differ.
double largest_difference(const Trajectory& a, const Trajectory& b, double scale, const lostopos::Vec3& offset);

}  // namespace foamsim
