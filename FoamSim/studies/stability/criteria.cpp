#include "FoamSim/studies/stability/criteria.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "FoamSim/scenes/methods.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

bool is_finite(const Metrics& m) {
  bool finite = std::isfinite(m.energy) && std::isfinite(m.area) && m.impulse.allFinite() && m.centroid.allFinite();
  for (const auto& volume : m.volumes) finite = finite && std::isfinite(volume.volume);
  return finite;
}

std::string percent(const char* what, double value, double limit) {
  char text[160];
  std::snprintf(text, sizeof(text), "%s %.3g%%; the limit is %.3g%%", what, 100 * value, 100 * limit);
  return text;
}

// |a − b| over a size that is not smaller than either's, or 0 when both are 0.
double relative(double a, double b, double size) {
  const double difference = std::abs(a - b);
  return difference == 0 ? 0 : difference / size;
}

// NaN compares false with everything: what is not a number counts as an infinite difference.
double larger_or_infinite(double largest, double difference) {
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(largest, difference);
}

double sample_difference(const Metrics& a, const Metrics& b, double scale, const Vec3& offset) {
  if (a.vertices != b.vertices || a.triangles != b.triangles || a.regions != b.regions ||
      a.volumes.size() != b.volumes.size())
    return std::numeric_limits<double>::infinity();
  const double squared = scale * scale, length = scale * std::sqrt(a.area);
  double largest = 0;
  auto take = [&largest](double difference) { largest = larger_or_infinite(largest, difference); };
  take(relative(a.area * squared, b.area, b.area));
  take(relative(a.energy * squared * squared * scale, b.energy, b.energy));
  take((offset + a.centroid * scale - b.centroid).norm() / length);
  if (b.impulse_scale > 0) take((a.impulse * squared * squared - b.impulse).norm() / b.impulse_scale);
  for (std::size_t i = 0; i < a.volumes.size(); ++i)
    take(relative(a.volumes[i].volume * squared * scale, b.volumes[i].volume, std::abs(b.volumes[i].volume)));
  take(std::abs(a.angle_rms_deg.value_or(0) - b.angle_rms_deg.value_or(0)));
  take(std::abs(a.triangle_angle_min_deg - b.triangle_angle_min_deg));
  return largest;
}

}  // namespace

PhysicsLimits physics_limits(std::string_view method) {
  if (method == conservative_method) return {.energy_rise = 0.002, .volume_drift = 0.001, .impulse_drift = 0.02};
  return {};
}

PhysicsFigures physics_figures(const Trajectory& trajectory) {
  PhysicsFigures figures;
  double least_energy = std::numeric_limits<double>::infinity(), rise = 0, excess = 0, impulse = 0, scale = 0;
  const auto& samples = trajectory.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Metrics& m = samples[i];
    figures.finite = figures.finite && is_finite(m);
    figures.volume_drift = std::max(figures.volume_drift, m.volume_drift_max);
    if (i == 0) continue;
    least_energy = std::min(least_energy, m.energy);
    rise = std::max(rise, m.energy - least_energy);
    excess = std::max(excess, m.energy - samples[1].energy);
    impulse = std::max(impulse, (m.impulse - samples[1].impulse).norm());
    scale = std::max(scale, m.impulse_scale);
  }
  if (samples.size() > 1 && samples[1].energy != 0) {
    figures.energy_rise = rise / std::abs(samples[1].energy);
    figures.energy_excess = excess / std::abs(samples[1].energy);
  }
  if (scale > 0) figures.impulse_drift = impulse / scale;
  return figures;
}

Judgement& Judgement::require(bool condition, const std::string& reason) {
  if (condition || !verdict_.passed) return *this;
  verdict_.passed = false;
  verdict_.reason = reason;
  return *this;
}

Judgement& Judgement::require_sound(const Trajectory& trajectory) {
  const std::string run = trajectory.label.empty() ? "" : trajectory.label + ": ";
  require(physics_figures(trajectory).finite, run + "something is not finite");
  require(trajectory.defect.empty(), run + "audit " + trajectory.defect);
  require(trajectory.error.empty(), run + trajectory.error);
  require(!trajectory.blown_up, run + "energy blew up after step " + std::to_string(trajectory.steps()));
  require(!trajectory.out_of_time, run + "out of wall time after step " + std::to_string(trajectory.steps()));
  return require(trajectory.complete(), run + "ended after step " + std::to_string(trajectory.steps()));
}

Judgement& Judgement::require_physics(const Trajectory& trajectory) {
  const PhysicsLimits& limits = trajectory.limits;
  const PhysicsFigures figures = physics_figures(trajectory);
  const std::string run = trajectory.label.empty() ? "" : trajectory.label + ": ";
  require_sound(trajectory);
  require(figures.energy_rise <= limits.energy_rise,
          run + percent("energy rises by", figures.energy_rise, limits.energy_rise));
  require(figures.volume_drift <= limits.volume_drift,
          run + percent("volume drifts by", figures.volume_drift, limits.volume_drift));
  return require(figures.impulse_drift <= limits.impulse_drift,
                 run + percent("impulse drifts by", figures.impulse_drift, limits.impulse_drift));
}

Judgement& Judgement::require_stable(const Trajectory& trajectory) {
  const PhysicsLimits& limits = trajectory.limits;
  const PhysicsFigures figures = physics_figures(trajectory);
  const std::string run = trajectory.label.empty() ? "" : trajectory.label + ": ";
  require_sound(trajectory);
  require(figures.energy_excess <= limits.energy_rise,
          run + percent("energy is above the start's by", figures.energy_excess, limits.energy_rise));
  return require(figures.volume_drift <= limits.volume_drift,
                 run + percent("volume drifts by", figures.volume_drift, limits.volume_drift));
}

Judgement& Judgement::set_figure(std::string name, std::optional<double> value) {
  verdict_.figure_name = std::move(name);
  verdict_.figure = value;
  return *this;
}

Verdict within_physics(std::span<const Trajectory> trajectories) {
  return Judgement().require_physics(trajectories.front()).verdict();
}

double largest_difference(const Trajectory& a, const Trajectory& b, double scale, const Vec3& offset) {
  if (a.samples.size() != b.samples.size() || a.end_positions.size() != b.end_positions.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  auto take = [&largest](double difference) { largest = larger_or_infinite(largest, difference); };
  for (std::size_t i = 0; i < a.samples.size(); ++i) take(sample_difference(a.samples[i], b.samples[i], scale, offset));
  if (a.samples.empty()) return largest;
  const double length = scale * std::sqrt(a.samples.front().area);
  for (std::size_t i = 0; i < a.end_positions.size(); ++i)
    take((offset + a.end_positions[i] * scale - b.end_positions[i]).norm() / length);
  return largest;
}

}  // namespace foamsim
