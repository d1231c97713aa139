#include "FoamSim/studies/modes/mode_oscillation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "Base/error.h"
#include "FoamSim/dynamics/conservative.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/dynamics/vortex_sheet.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/pressure/edge_angle.h"
#include "FoamSim/sheet/pressure/vertex_area/averaged.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "FoamSim/studies/modes/modal_amplitudes.h"
#include "FoamSim/studies/require.h"

namespace foamsim {
namespace {

void check(const ModeOptions& o) {
  require(o.mode >= 2 && o.mode < static_cast<long>(fitted_modes), "mode study: the mode has to be 2 to 6");
  require(o.subdivisions >= 1 && o.subdivisions <= 7, "mode study: subdivisions have to be 1 to 7");
  require(o.amplitude > 0 && o.amplitude <= 0.2,
          "mode study: the amplitude has to be > 0 and at most 0.2 of the radius");
  require(std::isfinite(o.radius) && o.radius > 0, "mode study: the radius has to be a finite length > 0");
  require(std::isfinite(o.sigma) && o.sigma > 0, "mode study: sigma has to be a finite number > 0");
  require(std::isfinite(o.dt) && o.dt >= 0, "mode study: dt has to be a finite time >= 0; 0 chooses one");
  require(o.periods >= 1, "mode study: at least one period has to be measured");
}

SimulationParts tension_only(double sigma, bool conservative) {
  if (conservative) {
    SimulationParts parts{.dynamics = std::make_unique<Conservative>(ConservativeOptions{.stepping = Stepping::rk4})};
    parts.effects.push_back(std::make_unique<SurfaceTension>(sigma, nullptr));
    return parts;
  }
  SimulationParts parts{.dynamics = std::make_unique<VortexSheet>(make_biot_savart("direct"), make_integrator("rk4"))};
  parts.effects.push_back(
      std::make_unique<SurfaceTension>(sigma, std::make_unique<EdgeAngle>(std::make_unique<AveragedArea>())));
  return parts;
}

lostopos::SurfaceMesh perturbed_sphere(const ModeOptions& o) {
  lostopos::SurfaceMesh mesh = icosphere(o.subdivisions, o.radius);
  perturb_with_mode(mesh, o.mode, o.amplitude);
  return mesh;
}

// The shortest waves that the regularised sheet carries have a frequency near 1.6 √(σ/δ³), and explicit steps must
// follow them; the mode itself is to be sampled well enough that its period is right to 0.1 %.
double chosen_dt(double sigma, double delta, double omega) {
  return std::min(0.75 * std::sqrt(delta * delta * delta / sigma), 2 * std::numbers::pi / omega / 60);
}

Simulation make_simulation(ModeOptions& o, double omega) {
  lostopos::SurfaceMesh mesh = perturbed_sphere(o);
  SimulationOptions simulation;
  simulation.tracker.collisions = false;  // a convex bubble meets nothing
  simulation.delta = (o.conservative ? 0.5 : 0.75) * resolved_resolution(simulation, mesh);
  if (o.dt == 0) o.dt = chosen_dt(o.sigma, simulation.delta, omega);
  simulation.dt = o.dt;
  return {std::move(mesh), simulation, tension_only(o.sigma, o.conservative)};
}

// Zero crossings of a sampled function, by straight lines between samples.
class ZeroCrossings {
 public:
  void add(double time, double value) {
    if (has_last_ && (value > 0) != (last_value_ > 0))
      times_.push_back(last_time_ + (time - last_time_) * last_value_ / (last_value_ - value));
    has_last_ = true;
    last_time_ = time;
    last_value_ = value;
  }
  std::size_t count() const { return times_.size(); }
  std::vector<double> gaps() const {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times_.size(); ++i) gaps.push_back(times_[i] - times_[i - 1]);
    return gaps;
  }
  // Slope of the straight line through (number, time).
  double mean_gap() const {
    const double middle = (static_cast<double>(times_.size()) - 1) / 2;
    double moment = 0, squares = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const double number = static_cast<double>(i) - middle;
      moment += number * times_[i];
      squares += number * number;
    }
    return moment / squares;
  }

 private:
  std::vector<double> times_;
  double last_time_ = 0, last_value_ = 0;
  bool has_last_ = false;
};

class ModeRunner {
 public:
  ModeRunner(const ModeOptions& options, const ModeCallback& progress) : progress_(progress) {
    run_.options = options;
    run_.omega_theory = mode_frequency(options.mode, options.sigma, options.radius);
  }

  ModeRun run() {
    Simulation simulation = make_simulation(run_.options, run_.omega_theory);
    run_.triangles = simulation.mesh().triangle_count();
    run_.resolution = simulation.resolution();
    run_.delta = simulation.delta();
    start_at_rest(simulation);
    const auto crossings_wanted = static_cast<std::size_t>(2 * run_.options.periods + 1);
    const double patience = 4 * (static_cast<double>(run_.options.periods) + 1) * 2 * std::numbers::pi;
    while (crossings_.count() < crossings_wanted) {
      if (simulation.time() * run_.omega_theory > patience)
        throw base::Error("mode study: the bubble with " + std::to_string(run_.triangles) +
                          " triangles does not oscillate in mode " + std::to_string(run_.options.mode));
      step(simulation);
      if (progress_)
        progress_({run_.options.mode, run_.triangles,
                   static_cast<double>(crossings_.count()) / static_cast<double>(crossings_wanted)});
    }
    finish();
    return std::move(run_);
  }

 private:
  // A step lets tension act for the whole of dt before the air moves. Taking half of that back puts Γ = 0 at the start,
  // between the two, and not half a step before.
  void start_at_rest(Simulation& simulation) const {
    const EffectStep back{simulation.mesh(), simulation.geometry(), 0.0, -run_.options.dt / 2};
    for (const auto& effect : simulation.effects()) effect->update_circulation(back, simulation.circulation());
  }

  void step(Simulation& simulation) {
    const auto amplitudes = modal_amplitudes(simulation.mesh());
    const auto mode = static_cast<std::size_t>(run_.options.mode);
    const double time = simulation.time(), measured = amplitudes[mode] / run_.options.radius;
    const StepReport report = simulation.step();
    if (run_.samples.empty()) {
      start_amplitude_ = measured;
      start_potential_ = report.potential_energy;
    }
    run_.samples.push_back({time, measured, start_amplitude_ * std::cos(run_.omega_theory * time),
                            report.kinetic_energy, report.potential_energy - start_potential_});
    crossings_.add(time, measured);
    for (std::size_t k = 1; k < fitted_modes; ++k)
      if (k != mode)
        run_.peak_other_mode = std::max(run_.peak_other_mode, std::abs(amplitudes[k]) / run_.options.radius);
    run_.peak_kinetic_energy = std::max(run_.peak_kinetic_energy, report.kinetic_energy);
    run_.peak_impulse = std::max(run_.peak_impulse, report.impulse.norm());
    run_.peak_impulse_scale = std::max(run_.peak_impulse_scale, report.impulse_scale);
    ++run_.steps;
  }

  void finish() {
    run_.half_periods = crossings_.gaps();
    run_.omega = std::numbers::pi / crossings_.mean_gap();
    const ModeSample& start = run_.samples.front();
    for (const ModeSample& s : run_.samples) {
      const double change = s.kinetic_energy + s.potential_energy - (start.kinetic_energy + start.potential_energy);
      run_.energy_drift = std::max(run_.energy_drift, std::abs(change) / run_.peak_kinetic_energy);
    }
  }

  const ModeCallback& progress_;
  ModeRun run_;
  ZeroCrossings crossings_;
  double start_amplitude_ = 0, start_potential_ = 0;
};

}  // namespace

double mode_frequency(long mode, double sigma, double radius) {
  const auto n = static_cast<double>(mode);
  return std::sqrt(4 * sigma * n * (n - 1) * (n + 1) * (n + 2) / ((2 * n + 1) * radius * radius * radius));
}

ModeRun run_mode(const ModeOptions& options, const ModeCallback& progress) {
  check(options);
  return ModeRunner(options, progress).run();
}

ModeConvergence mode_convergence(std::vector<ModeRun> runs) {
  require(runs.size() >= 2, "mode study: convergence needs at least two runs");
  ModeConvergence convergence;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const ModeRun &coarse = runs[i - 1], &fine = runs[i];
    require(coarse.options.mode == fine.options.mode && coarse.delta > fine.delta,
            "mode study: runs have to be of one mode, from coarse to fine");
    convergence.observed_orders.push_back(std::log(std::abs(coarse.frequency_error() / fine.frequency_error())) /
                                          std::log(coarse.delta / fine.delta));
  }
  const ModeRun &coarse = runs[runs.size() - 2], &fine = runs.back();
  convergence.extrapolated_omega = fine.omega + (fine.omega - coarse.omega) * fine.delta / (coarse.delta - fine.delta);
  convergence.runs = std::move(runs);
  return convergence;
}

ModeConvergence study_mode(ModeOptions options, const std::vector<long>& subdivisions, const ModeCallback& progress) {
  require(subdivisions.size() >= 2 && std::ranges::is_sorted(subdivisions, std::ranges::less_equal{}),
          "mode study: two or more numbers of subdivisions, ascending, have to be given");
  std::vector<ModeRun> runs;
  for (long n : subdivisions) {
    options.subdivisions = n;
    runs.push_back(run_mode(options, progress));
  }
  return mode_convergence(std::move(runs));
}

}  // namespace foamsim
