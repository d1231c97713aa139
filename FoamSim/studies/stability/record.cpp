#include "FoamSim/studies/stability/record.h"

#include <chrono>
#include <cmath>
#include <exception>

#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Recorder {
 public:
  Recorder(const RecordOptions& options, const RecordHooks& hooks) : options_(options), hooks_(hooks) {
    trajectory_.steps_asked = options.steps;
  }

  Trajectory record(CaseMotion& motion) {
    add(motion.start());
    audit(motion);
    while (trajectory_.steps() < options_.steps && may_go_on()) {
      add(motion.step());
      if (is_audited(trajectory_.steps())) audit(motion);
      if (hooks_.progress) hooks_.progress(trajectory_.steps());
    }
    return finish(motion);
  }

  Trajectory& trajectory() { return trajectory_; }

 private:
  bool may_go_on() {
    trajectory_.out_of_time = seconds_since(begun_) > options_.most_seconds;
    trajectory_.interrupted = hooks_.interrupted && hooks_.interrupted();
    trajectory_.blown_up = has_blown_up();
    return !trajectory_.out_of_time && !trajectory_.interrupted && !trajectory_.blown_up;
  }

  // The steps of such a motion take ever longer, and tell nothing any more.
  bool has_blown_up() const {
    const auto& samples = trajectory_.samples;
    return samples.size() > 1 && std::abs(samples.back().energy) > options_.most_energy * std::abs(samples[1].energy);
  }

  bool is_audited(long step) const {
    return step * options_.audits / options_.steps != (step - 1) * options_.audits / options_.steps;
  }

  void audit(const CaseMotion& motion) {
    if (!trajectory_.defect.empty()) return;
    const auto report = lostopos::audit(motion.mesh(), {.closed_regions = options_.closed_surface, .max_findings = 1});
    if (!report.clean())
      trajectory_.defect = "after step " + std::to_string(trajectory_.steps()) + ": " + report.findings.front().message;
  }

  // Times by stage are not what is judged, and strings in every sample would be most of a long trajectory's memory.
  void add(Metrics metrics) {
    metrics.times = {};
    trajectory_.samples.push_back(std::move(metrics));
    trajectory_.seconds = seconds_since(begun_);
  }

  Trajectory finish(const CaseMotion& motion) {
    for (lostopos::Vertex v : motion.mesh().vertices()) trajectory_.end_positions.push_back(motion.mesh().position(v));
    return std::move(trajectory_);
  }

  const RecordOptions& options_;
  const RecordHooks& hooks_;
  Clock::time_point begun_ = Clock::now();
  Trajectory trajectory_;
};

}  // namespace

Trajectory record(const std::function<std::unique_ptr<CaseMotion>()>& start, const RecordOptions& options,
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
