#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "FoamSim/dynamics/step_report.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

/// Characteristic time √(R³/σ) of a bubble of the mean volume (T); 0 when there is no bubble or no tension.
double characteristic_time(const std::vector<lostopos::RegionVolume>& volumes, double sigma);

/// Tells when a surface has come to rest: over a whole characteristic time the kinetic energy stays below 1e-6 of the
/// potential energy, and the RMS deviation of the junction angles changes by less than 0.02°.
class RestDetector {
 public:
  static constexpr double energy_ratio = 1e-6;
  static constexpr double angle_change_deg = 0.02;

  struct Sample {
    double time, angle;
  };

  /// `quiet`: what an earlier detector had seen, to go on with.
  explicit RestDetector(double window, std::deque<Sample> quiet = {}) : window_(window), quiet_(std::move(quiet)) {}
  /// Takes the energies of the next step; true when the surface is at rest, which it never is for a window of 0.
  /// `rms_angle_deg` measures the angles of the surface after the step (JunctionAngles), which only a quiet one needs.
  bool add(double time, const StepReport& report, const std::function<std::optional<double>()>& rms_angle_deg);
  /// Unbroken quiet samples, no older than the window.
  const std::deque<Sample>& quiet() const { return quiet_; }

 private:
  double window_;
  std::deque<Sample> quiet_;
};

}  // namespace foamsim
