#include "LosTopos/run/run.h"

#include <array>
#include <cmath>
#include <optional>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/options/option_value.h"
#include "Base/timing/stopwatch.h"
#include "LosTopos/run/run_writer.h"

namespace lostopos::run {
namespace {

// Every step up to here, and so its time, is a number that a double holds.
constexpr double most_steps = 9007199254740992.0;  // 2⁵³

class Run {
 public:
  Run(Motion& motion, const Plan& plan, const Output& output, const Hooks& hooks)
      : motion_(motion), plan_(plan), hooks_(hooks) {
    outcome_.first_step = motion.steps();
    if (!output.folder.empty()) writer_.emplace(motion, output);
    if (plan.at_rest) outcome_.end = End::not_at_rest;
  }

  Outcome go() {
    try {
      loop();
      if (outcome_.message.empty()) outcome_.message = remark();
      finish();
    } catch (const base::DiskError& error) {
      throw base::DiskError(error.what() + way_on_from_a_full_disk());
    }
    return std::move(outcome_);
  }

 private:
  void loop() {
    while (motion_.steps() < plan_.last_step) {
      if (hooks_.interrupted && hooks_.interrupted()) return end_as(End::interrupted);
      const long step = motion_.steps() + 1;
      try {
        motion_.step();
      } catch (const base::Interrupted&) {
        return end_as(End::interrupted);
      } catch (const base::InputError&) {
        throw;
      } catch (const base::Error& error) {
        return fail(step, error.what());
      }
      after_step();
      if (plan_.defect) {
        const std::string defect = plan_.defect();
        if (!defect.empty()) return fail(step, defect);
      }
      if (plan_.at_rest && plan_.at_rest()) return end_as(End::at_rest);
      if (plan_.stop && plan_.stop()) return end_as(End::stopped);
    }
  }

  void after_step() {
    outcome_.work.add(motion_.last());
    if (writer_) {
      const base::TimedScope timed(outcome_.work.times, "write");
      writer_->write_step();
    }
    if (hooks_.stepped) hooks_.stepped(static_cast<double>(motion_.steps()) / static_cast<double>(plan_.last_step));
  }

  void end_as(End end) { outcome_.end = end; }

  void fail(long step, const std::string& why) {
    outcome_.end = End::failed;
    outcome_.message = "step " + std::to_string(step) + ": " + why;
  }

  std::string remark() const {
    if (outcome_.first_step > 0 && outcome_.first_step >= plan_.last_step)
      return "already at step " + std::to_string(outcome_.first_step) + ", and asked to run to step " +
             std::to_string(plan_.last_step) + ": nothing was left to do; ask for more steps or time";
    if (outcome_.end == End::not_at_rest)
      return "not at rest after step " + std::to_string(plan_.last_step) + ", and given up there";
    if (outcome_.end == End::interrupted && writer_ && writer_->saves_checkpoints())
      return "to go on: --resume " + writer_->folder().checkpoint().string();
    return {};
  }

  std::string way_on_from_a_full_disk() const {
    const std::filesystem::path checkpoint = writer_ ? writer_->folder().checkpoint() : std::filesystem::path();
    if (!std::filesystem::exists(checkpoint)) return "; no checkpoint was written before";
    return "; to go on when there is room: --resume " + checkpoint.string();
  }

  // The last good state, unless the last step has just written it.
  void finish() {
    if (writer_) {
      const base::TimedScope timed(outcome_.work.times, "write");
      writer_->write_end();
      outcome_.last_frame = writer_->last_frame();
      if (writer_->saves_checkpoints()) outcome_.checkpoint = writer_->folder().checkpoint();
    }
    outcome_.wall_seconds = watch_.seconds();
    if (writer_) writer_->write_json(name(outcome_.end), outcome_);
  }

  Motion& motion_;
  const Plan& plan_;
  const Hooks& hooks_;
  base::Stopwatch watch_;
  std::optional<RunWriter> writer_;
  Outcome outcome_;
};

}  // namespace

const char* name(End end) {
  constexpr std::array names{"finished", "at rest", "not at rest", "stopped", "interrupted", "failed"};
  return names.at(static_cast<std::size_t>(end));
}

Outcome run_motion(Motion& motion, const Plan& plan, const Output& output, const Hooks& hooks) {
  return Run(motion, plan, output, hooks).go();
}

Outcome run_in_memory(Motion& motion, const Plan& plan, const Hooks& hooks) {
  const Output nothing_written;
  return run_motion(motion, plan, nothing_written, hooks);
}

void require_countable(double steps, double dt) {
  if (steps <= most_steps) return;
  throw base::InputError(base::to_text(steps) + " steps of dt = " + base::to_text(dt) +
                         " are more than a run can count; the largest is " + base::to_text(most_steps) +
                         " steps, a time of " + base::to_text(most_steps * dt));
}

long steps_of(double time, double dt) {
  const double steps = time / dt;
  require_countable(steps, dt);
  return std::lround(steps);
}

}  // namespace lostopos::run
