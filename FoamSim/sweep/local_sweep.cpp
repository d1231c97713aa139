#include "FoamSim/sweep/local_sweep.h"

#include <chrono>
#include <list>
#include <thread>

namespace foamsim::sweep {
namespace {

class Workers {
 public:
  Workers(const Sweep& sweep, const LocalSettings& settings, const LocalHooks& hooks, std::vector<RunState>& states)
      : sweep_(sweep), settings_(settings), hooks_(hooks), states_(states) {}

  void go(const std::vector<std::size_t>& todo) {
    constexpr auto interval = std::chrono::milliseconds(20);
    std::size_t next = 0;
    bool stopping = false;
    while (!active_.empty() || (next < todo.size() && !stopping)) {
      if (!stopping && hooks_.interrupted && hooks_.interrupted()) {
        stopping = true;
        if (settings_.pass_on_signals)
          for (const auto& [run, process] : active_) process.stop();
      }
      while (!stopping && next < todo.size() && active_.size() < static_cast<std::size_t>(settings_.workers))
        start(todo[next++]);
      if (hooks_.waiting) hooks_.waiting(active_.size());
      if (!active_.empty()) std::this_thread::sleep_for(interval);
      take_ended();
    }
  }

 private:
  void start(std::size_t run) {
    auto started = StartedRun::start(sweep_, run, settings_.launcher);
    if (!started) {
      states_[run] = look_at(sweep_.run_folder(run));
      return;
    }
    active_.emplace_back(run, std::move(*started));
    states_[run] = {Status::running, {}, {}};
    if (hooks_.started) hooks_.started(run);
  }

  void take_ended() {
    for (auto it = active_.begin(); it != active_.end();) {
      auto& [run, process] = *it;
      const std::optional<RunState> state = process.end();
      if (!state) {
        ++it;
        continue;
      }
      states_[run] = *state;
      if (hooks_.ended) hooks_.ended(run);
      it = active_.erase(it);
    }
  }

  const Sweep& sweep_;
  const LocalSettings& settings_;
  const LocalHooks& hooks_;
  std::vector<RunState>& states_;
  std::list<std::pair<std::size_t, StartedRun>> active_;
};

}  // namespace

std::vector<RunState> states_of(const Sweep& sweep) {
  std::vector<RunState> states;
  states.reserve(sweep.runs.size());
  for (std::size_t run = 0; run < sweep.runs.size(); ++run) states.push_back(look_at(sweep.run_folder(run)));
  return states;
}

void run_locally(const Sweep& sweep, const std::vector<std::size_t>& todo, const LocalSettings& settings,
                 const LocalHooks& hooks, std::vector<RunState>& states) {
  Workers(sweep, settings, hooks, states).go(todo);
}

}  // namespace foamsim::sweep
