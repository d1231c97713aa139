#include "FoamSim/studies/accuracy/accuracy_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "Base/timing/stopwatch.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/metrics/rest_detector.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/studies/require.h"
#include "LosTopos/error.h"

namespace foamsim {
namespace {

std::string label_of(const AccuracyCombination& c) {
  return c.area + " N = " + std::to_string(c.n) + " " + c.integrator;
}

// Roughly what a combination costs: each step's velocities take the square of the number of triangles, about 4N², and
// the rest is linear in it.
double weight_of(const AccuracyCombination& c) {
  const double triangles = 4.0 * static_cast<double>(c.n * c.n);
  const double evaluations = c.integrator == "rk4" ? 4 : 1;
  return triangles * (1 + evaluations * triangles / 8000) / c.dt;
}

Scene scene_of(const AccuracyCombination& c, const AccuracyOptions& o) {
  Scene scene = built_in_scene("doublebubble");
  const char* where = "accuracy study";
  scene.options.set("n", c.n, where);
  choose_method(scene.options, c.area, where);
  if (c.area == conservative_method)
    scene.options.set("stepping", std::string(c.integrator == "rk4" ? "rk4" : "kick-drift"), where);
  else
    scene.options.set("integrator", c.integrator, where);
  scene.options.set("dt", c.dt, where);
  scene.options.set("remeshing.enabled", o.remeshing, where);
  scene.options.append("effects", "damping", where);
  scene.options.set("damping", o.damping, where);
  return scene;
}

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr std::array stage_names{"velocity", "move", "remesh", "geometry"};

// The effects' stages, which carry their names, as one.
void add_stages(const base::StageTimes& step, base::StageTimes& sum) {
  double effects = step.total();
  for (const char* stage : stage_names) effects -= step.seconds(stage);
  sum.add("effects", effects);
  for (const char* stage : stage_names) sum.add(stage, step.seconds(stage));
}

class AccuracyRun {
 public:
  AccuracyRun(const AccuracyCombination& c, const AccuracyOptions& options)
      : options_(options),
        scene_(scene_of(c, options)),
        simulation_(make_simulation(scene_)),
        start_volumes_(lostopos::region_volumes(simulation_.mesh())),
        rest_(characteristic_time(start_volumes_, scene_.options.number("sigma"))) {
    row_.area = c.area;
    row_.n = c.n;
    row_.integrator = c.integrator;
    row_.dt = c.dt;
    row_.ended = "not at rest";
  }

  // False when interrupted. `progress` takes the fraction of the time that may pass.
  bool go(const std::function<void(double)>& progress, const std::function<bool()>& interrupted) {
    const double cpu = cpu_now();
    const base::Stopwatch watch;
    const long end = std::lround(options_.most_time / row_.dt);
    try {
      while (row_.ended == "not at rest" && simulation_.steps() < end) {
        if (interrupted && interrupted()) return false;
        step();
        if (progress) progress(static_cast<double>(simulation_.steps()) / static_cast<double>(end));
      }
    } catch (const lostopos::MotionError& error) {
      row_.ended = "failed";
      row_.reason = error.what();
    }
    row_.cpu_seconds = cpu_now() - cpu;
    row_.wall_seconds = watch.seconds();
    return true;
  }

  AccuracyRow measured() {
    row_.steps = simulation_.steps();
    row_.time = simulation_.time();
    row_.triangles = simulation_.mesh().triangle_count();
    row_.resolution = simulation_.resolution();
    row_.volume_drift = lostopos::largest_volume_drift(lostopos::region_volumes(simulation_.mesh()), start_volumes_);
    try {
      row_.errors = equilibrium_errors(simulation_.mesh());
    } catch (const base::InputError& error) {
      if (row_.reason.empty()) row_.reason = error.what();
    }
    return std::move(row_);
  }

 private:
  void step() {
    const StepReport report = simulation_.step();
    add_stages(report.times, row_.stages);
    const base::TimedScope timed(row_.stages, "rest");
    const auto angles = [this] { return junction_angles(simulation_.mesh()).rms_deviation_deg; };
    if (rest_.add(simulation_.time(), report, angles)) row_.ended = "at rest";
  }

  const AccuracyOptions& options_;
  Scene scene_;
  Simulation simulation_;
  std::vector<lostopos::RegionVolume> start_volumes_;
  RestDetector rest_;
  AccuracyRow row_;
};

}  // namespace

std::vector<AccuracyCombination> combinations(const AccuracyOptions& o) {
  std::vector<AccuracyCombination> all;
  for (long n : o.sizes)
    for (const std::string& area : o.areas)
      for (const std::string& integrator : o.integrators)
        for (double dt : o.steps_of_time) all.push_back({n, area, integrator, dt});
  return all;
}

void validate(const AccuracyOptions& o) {
  require(!o.areas.empty() && !o.sizes.empty() && !o.integrators.empty() && !o.steps_of_time.empty(),
          "accuracy study: one strategy, size, integrator and dt, or more of each, have to be given");
  for (const std::string& area : o.areas) require_method(*built_in_catalogue(), area);
  for (const std::string& integrator : o.integrators) integrators().find(integrator);
  for (long n : o.sizes) require(n >= 8 && n <= 192, "accuracy study: sizes have to be 8 to 192");
  for (double dt : o.steps_of_time)
    require(std::isfinite(dt) && dt > 0, "accuracy study: dt has to be a finite time > 0");
  require(o.damping > 0 && o.damping <= 1, "accuracy study: damping has to be > 0 and at most 1");
  require(std::isfinite(o.most_time) && o.most_time > 0, "accuracy study: the longest time has to be finite and > 0");
}

std::vector<AccuracyRow> study_accuracy(const AccuracyOptions& options, const AccuracyHooks& hooks) {
  validate(options);
  const auto all = combinations(options);
  double weight = 0, done = 0;
  for (const AccuracyCombination& c : all) weight += weight_of(c);
  std::vector<AccuracyRow> rows;
  for (const AccuracyCombination& c : all) {
    AccuracyRun run(c, options);
    std::function<void(double)> progress;
    if (hooks.progress)
      progress = [&](double part) { hooks.progress(label_of(c), (done + part * weight_of(c)) / weight); };
    if (!run.go(progress, hooks.interrupted)) break;
    rows.push_back(run.measured());
    if (hooks.row) hooks.row(rows.back());
    done += weight_of(c);
  }
  return rows;
}

}  // namespace foamsim
