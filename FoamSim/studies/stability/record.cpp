#include "FoamSim/studies/stability/record.h"

#include <cmath>
#include <exception>

#include "Base/timing/stopwatch.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/run/run.h"

namespace foamsim {
namespace {

class Recorder {
 public:
  Recorder(const RecordOptions& options, const RecordHooks& hooks) : options_(options), hooks_(hooks) {
    trajectory_.steps_asked = options.steps;
  }

  Trajectory record(MeasuredMotion& motion) {
    add(motion.metrics());
    audit(motion);
    const auto outcome = lostopos::run::run_in_memory(
        motion, {.last_step = options_.steps, .stop = [this] { return has_to_stop(); }},
        {.stepped = [&](double) { take_step(motion); }, .interrupted = hooks_.interrupted});
    trajectory_.error = outcome.end == lostopos::run::End::failed ? outcome.message : "";
    trajectory_.interrupted = outcome.end == lostopos::run::End::interrupted;
    return finish(motion);
  }

  Trajectory& trajectory() { return trajectory_; }

 private:
  void take_step(const MeasuredMotion& motion) {
    add(motion.metrics());
    if (is_audited(trajectory_.steps())) audit(motion);
    if (hooks_.progress) hooks_.progress(trajectory_.steps());
  }

  // What has come to its last step need not be stopped.
  bool has_to_stop() {
    if (trajectory_.steps() >= options_.steps) return false;
    trajectory_.out_of_time = watch_.seconds() > options_.most_seconds;
    trajectory_.blown_up = has_blown_up();
    return trajectory_.out_of_time || trajectory_.blown_up;
  }

  // The steps of such a motion take ever longer, and tell nothing any more.
  bool has_blown_up() const {
    const auto& samples = trajectory_.samples;
    return samples.size() > 1 && std::abs(samples.back().energy) > options_.most_energy * std::abs(samples[1].energy);
  }

  bool is_audited(long step) const {
    return step * options_.audits / options_.steps != (step - 1) * options_.audits / options_.steps;
  }

  void audit(const MeasuredMotion& motion) {
    if (!trajectory_.defect.empty()) return;
    const auto report = lostopos::audit(motion.mesh(), {.closed_regions = options_.closed_surface, .max_findings = 1});
    if (!report.clean())
      trajectory_.defect = "after step " + std::to_string(trajectory_.steps()) + ": " + report.findings.front().message;
  }

  // Times by stage are not what is judged, and strings in every sample would be most of a long trajectory's memory.
  void add(Metrics metrics) {
    metrics.times = {};
    trajectory_.samples.push_back(std::move(metrics));
    trajectory_.seconds = watch_.seconds();
  }

  Trajectory finish(const MeasuredMotion& motion) {
    for (lostopos::Vertex v : motion.mesh().vertices()) trajectory_.end_positions.push_back(motion.mesh().position(v));
    return std::move(trajectory_);
  }

  const RecordOptions& options_;
  const RecordHooks& hooks_;
  base::Stopwatch watch_;
  Trajectory trajectory_;
};

}  // namespace

Trajectory record(const std::function<std::unique_ptr<MeasuredMotion>()>& start, const RecordOptions& options,
                  const RecordHooks& hooks) {
  Recorder recorder(options, hooks);
  try {
    return recorder.record(*start());
  } catch (const std::exception& error) {
    Trajectory& trajectory = recorder.trajectory();
    trajectory.error = "step " + std::to_string(trajectory.steps() + 1) + ": " + error.what();
    return std::move(trajectory);
  }
}

}  // namespace foamsim
