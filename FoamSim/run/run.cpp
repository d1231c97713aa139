#include "FoamSim/run/run.h"

#include <array>
#include <chrono>
#include <cmath>

#include "Base/timing/stopwatch.h"
#include "FoamSim/metrics/rest_detector.h"
#include "FoamSim/run/checkpoint.h"
#include "FoamSim/run/run_directory.h"
#include "FoamSim/run/run_json.h"
#include "FoamSim/run/run_writer.h"
#include "LosTopos/error.h"

namespace foamsim {

using Clock = std::chrono::steady_clock;

namespace {

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Start {
  Scene scene;
  Simulation simulation;
  std::vector<lostopos::RegionVolume> volumes;
  lostopos::Vec3 centroid;
};

Start start_from_scene(const Scene& scene) {
  Simulation simulation = make_simulation(scene);
  auto volumes = closed_region_volumes(simulation.mesh());
  const lostopos::Vec3 centroid = lostopos::surface_centroid(simulation.mesh());
  return {scene, std::move(simulation), std::move(volumes), centroid};
}

Start start_from_checkpoint(const std::filesystem::path& file, std::shared_ptr<const Catalogue> catalogue) {
  Checkpoint checkpoint = read_checkpoint(file, std::move(catalogue));
  Simulation simulation = resume(checkpoint);
  return {std::move(checkpoint.scene), std::move(simulation), std::move(checkpoint.start_volumes),
          checkpoint.start_centroid};
}

long last_step(const StopAt& stop, const Start& start) {
  const double dt = start.simulation.options().dt;
  auto steps_of = [dt](double time) { return std::lround(time / dt); };
  if (stop.steps && stop.time) return std::min(*stop.steps, steps_of(*stop.time));
  if (stop.steps) return *stop.steps;
  if (stop.time) return steps_of(*stop.time);
  if (stop.until_rest) {
    const double characteristic = characteristic_time(start.volumes, start.scene.options.number("sigma"));
    if (!(characteristic > 0))
      throw base::InputError(
          "--until-rest needs a bubble and a tension (sigma > 0), whose characteristic time tells what rest is; give "
          "--time or --steps here");
    return steps_of(rest_patience * characteristic);
  }
  return steps_of(start.scene.options.number("time"));
}

bool same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  return std::filesystem::weakly_canonical(a) == std::filesystem::weakly_canonical(b);
}

class Run {
 public:
  Run(Start start, const RunSettings& settings, const RunHooks& hooks, RunWriter writer)
      : start_(std::move(start)),
        settings_(settings),
        hooks_(hooks),
        writer_(std::move(writer)),
        rest_(characteristic_time(start_.volumes, start_.scene.options.number("sigma"))) {}

  /// The state at the start: the first thing that is written.
  void begin() {
    last_step_ = last_step(settings_.stop, start_);
    outcome_.first_step = start_.simulation.steps();
    outcome_.directory = writer_.directory().path();
    outcome_.start_centroid = start_.centroid;
    outcome_.topology_enabled = start_.simulation.options().tracker.topology.enabled;
    StepReport none;
    none.potential_energy = start_.simulation.potential_energy();
    outcome_.start = outcome_.last = measure(start_.simulation, none, 0, start_.volumes);
    if (settings_.resume.empty()) writer_.write_start(start_.simulation, outcome_.start);
  }

  RunOutcome go() {
    const auto begun = Clock::now();
    loop();
    // The last good state, unless the last step has just written it.
    {
      const base::TimedScope timed(outcome_.times, "write");
      writer_.write_frame(start_.simulation);
      writer_.write_checkpoint(start_.scene, start_.simulation, start_.volumes, start_.centroid);
    }
    outcome_.last_frame = writer_.last_frame();
    outcome_.checkpoint = writer_.directory().checkpoint();
    outcome_.wall_seconds = seconds_since(begun);
    write_run_json(writer_.directory().run_json(), start_.scene, settings_, outcome_);
    return std::move(outcome_);
  }

 private:
  void loop() {
    const long end = last_step_;
    outcome_.end = settings_.stop.until_rest ? RunEnd::not_at_rest : RunEnd::finished;
    while (start_.simulation.steps() < end) {
      if (hooks_.interrupted && hooks_.interrupted()) {
        outcome_.end = RunEnd::interrupted;
        return;
      }
      if (!one_step()) return;
      const Metrics& now = outcome_.last;
      if (settings_.stop.until_rest && rest_.add(now)) {
        outcome_.end = RunEnd::at_rest;
        return;
      }
      if (hooks_.progress) hooks_.progress(now, static_cast<double>(now.step) / static_cast<double>(end));
    }
    if (outcome_.end == RunEnd::not_at_rest)
      outcome_.message = "not at rest after step " + std::to_string(end) + "; see RestDetector for what rest means";
  }

  // False when the simulation cannot go on.
  bool one_step() {
    const auto begun = Clock::now();
    StepReport report;
    try {
      report = start_.simulation.step();
    } catch (const lostopos::MotionError& error) {
      outcome_.end = RunEnd::failed;
      outcome_.message = "step " + std::to_string(start_.simulation.steps() + 1) + ": " + error.what();
      return false;
    }
    {
      const base::TimedScope timed(report.times, "metrics");
      outcome_.last = measure(start_.simulation, report, 0, start_.volumes);
    }
    outcome_.last.step_seconds = seconds_since(begun);
    {
      const base::TimedScope timed(report.times, "write");
      writer_.write_step(start_.scene, start_.simulation, outcome_.last, start_.volumes, start_.centroid);
    }
    outcome_.times.add(report.times);
    outcome_.remesh += report.remesh;
    outcome_.move += report.move;
    report.topology.events.clear();  // written
    outcome_.topology += report.topology;
    return true;
  }

  Start start_;
  const RunSettings& settings_;
  const RunHooks& hooks_;
  RunWriter writer_;
  RestDetector rest_;
  long last_step_ = 0;
  RunOutcome outcome_;
};

}  // namespace

std::string_view name(RunEnd end) {
  constexpr std::array names{"finished", "at rest", "not at rest", "interrupted", "failed"};
  return names[static_cast<std::size_t>(end)];
}

RunOutcome run_scene(const Scene& scene, const RunSettings& settings, const RunHooks& hooks) {
  const bool resuming = !settings.resume.empty();
  Start start = resuming ? start_from_checkpoint(settings.resume, scene.catalogue) : start_from_scene(scene);
  const auto folder = settings.out.empty() ? settings.resume.parent_path() : settings.out;
  const bool going_on = resuming && same_folder(folder, settings.resume.parent_path());
  const RunDirectory directory = going_on ? RunDirectory::open(folder) : RunDirectory::create(folder, settings.force);
  // Until the first frame is written nothing has begun: an error leaves no trace of the run.
  Run run = [&] {
    try {
      RunWriter writer(directory, start.scene, going_on ? start.simulation.steps() : -1);
      Run made(std::move(start), settings, hooks, std::move(writer));
      made.begin();
      return made;
    } catch (...) {
      if (!going_on) directory.discard();
      throw;
    }
  }();
  return run.go();
}

}  // namespace foamsim
