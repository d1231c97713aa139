#include "MultiTracker/study/robustness.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <tuple>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/options/option_value.h"
#include "LosTopos/run/run_lock.h"
#include "MultiTracker/scenes/scene.h"
#include "MultiTracker/study/robustness_run.h"

namespace multitracker {

namespace {

namespace fs = std::filesystem;

base::OptionSet options_of_run(const RobustnessOptions& options, const RobustnessKey& key) {
  base::OptionSet set = options_of(scene_by_name("normal-flow"));
  set.set_default("frame_every", 0L);  // thousands of spheres make large frames, of which nobody asked for one
  for (const std::string& assignment : options.assignments) set.set_assignment(assignment, "--set");
  set.set("spheres", key.spheres, "--spheres");
  // As many whole steps of about that length as make up the motion exactly.
  const long count = std::max(1L, std::lround(options.total_motion / key.step));
  set.set("step", options.total_motion / static_cast<double>(count), "--steps-of");
  set.set("seed", key.seed, "--seeds");
  set.set("layout", options.layout, "--layout");
  set.set("steps", count, "--steps-of");
  return set;
}

std::vector<RobustnessKey> keys_of(const RobustnessOptions& options) {
  std::vector<RobustnessKey> keys;
  for (long spheres : options.spheres)
    for (double step : options.steps)
      for (long seed = 1; seed <= options.seeds; ++seed) keys.push_back({spheres, step, seed});
  return keys;
}

// What all rows of a folder have in common.
std::string settings_text(const RobustnessOptions& options) {
  return nlohmann::ordered_json{{"motion", options.total_motion},
                                {"until_closed", options.until_closed},
                                {"layout", options.layout},
                                {"set", options.assignments},
                                {"audit", options.audit_every_step}}
             .dump(1) +
         "\n";
}

// Rows that are done and checkpoints of those that are not, for as long as this study is at work there.
class Folder {
 public:
  explicit Folder(const RobustnessOptions& options) : path_(options.folder) {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) throw base::FileError("cannot make the folder " + path_.string() + ": " + error.message());
    lock_.emplace(path_);
    keep_settings(settings_text(options));
    if (fs::exists(table())) rows_ = read_robustness_table(table());
  }

  const RobustnessRun* row(const RobustnessKey& key) const {
    const auto found = std::ranges::find(rows_, key, &RobustnessRun::key);
    return found == rows_.end() ? nullptr : &*found;
  }

  void add(const RobustnessRun& run) {
    rows_.push_back(run);
    std::ranges::sort(rows_, {},
                      [](const RobustnessRun& r) { return std::tuple(r.key.spheres, r.key.step, r.key.seed); });
    write_robustness_table(table(), rows_);
  }

  fs::path of_run(const RobustnessKey& key) const {
    return path_ / "runs" /
           ("spheres" + std::to_string(key.spheres) + "-step" + base::to_text(key.step) + "-seed" +
            std::to_string(key.seed));
  }

 private:
  fs::path table() const { return path_ / "table.csv"; }

  void keep_settings(const std::string& text) const {
    const fs::path file = path_ / "study.json";
    if (fs::exists(file)) {
      std::ostringstream there;
      there << std::ifstream(file).rdbuf();
      if (there.str() == text) return;
      throw base::InputError(
          path_.string() + " holds a study with other settings (its study.json): repeat those, or give another --out");
    }
    base::AtomicFile out(file, base::Durability::machine);
    out.stream() << text;
    out.commit();
  }

  fs::path path_;
  std::optional<lostopos::run::RunLock> lock_;
  std::vector<RobustnessRun> rows_;
};

class Study {
 public:
  Study(const RobustnessOptions& options, const RobustnessHooks& hooks)
      : options_(options), hooks_(hooks), keys_(keys_of(options)), runs_(keys_.size()) {
    if (!options.folder.empty()) folder_.emplace(options);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (const RobustnessRun* row = folder_ ? folder_->row(keys_[i]) : nullptr)
        runs_[i] = *row;
      else
        waiting_.push_back(i);
    }
  }

  std::vector<RobustnessRun> go() {
    while (!active_.empty() || (!waiting_.empty() && !stopping_)) {
      if (!stopping_ && hooks_.interrupted && hooks_.interrupted()) stop();
      while (!stopping_ && !waiting_.empty() && active_.size() < static_cast<std::size_t>(options_.workers)) start();
      take_ended();
    }
    std::vector<RobustnessRun> done;
    for (std::optional<RobustnessRun>& run : runs_)
      if (run) done.push_back(std::move(*run));
    return done;
  }

 private:
  struct Active {
    std::size_t place;
    RobustnessTask task;
    ForkedChild child;
  };

  void stop() {
    stopping_ = true;
    for (Active& active : active_) active.child.ask_to_stop();
  }

  void start() {
    const std::size_t place = waiting_.front();
    waiting_.pop_front();
    const RobustnessKey& key = keys_[place];
    RobustnessTask task{.key = key,
                        .options = options_of_run(options_, key),
                        .until_closed = options_.until_closed,
                        .audit_every_step = options_.audit_every_step,
                        .folder = folder_ ? folder_->of_run(key) : fs::path()};
    ForkedChild child([&](const std::function<bool()>& stop) { return make_robustness_run(task, stop); },
                      options_.time_limit);
    active_.push_back({place, std::move(task), std::move(child)});
  }

  void take_ended() {
    const double longest_wait = 0.1 / static_cast<double>(std::max<std::size_t>(1, active_.size()));  // s
    for (auto it = active_.begin(); it != active_.end();) {
      const std::optional<ChildResult> end = it->child.result(longest_wait);
      if (!end) {
        ++it;
        continue;
      }
      // Of one that was stopped there is a row only where it had come to its end by then.
      std::optional<RobustnessRun> run = read_result(it->task, *end);
      if (run && !(stopping_ && run->verdict != Verdict::success)) take(it->place, std::move(*run));
      it = active_.erase(it);
    }
  }

  void take(std::size_t place, RobustnessRun run) {
    if (folder_) folder_->add(run);
    runs_[place] = std::move(run);
    const auto done = std::ranges::count_if(runs_, [](const auto& r) { return r.has_value(); });
    if (hooks_.done) hooks_.done(*runs_[place], static_cast<double>(done) / static_cast<double>(runs_.size()));
  }

  const RobustnessOptions& options_;
  const RobustnessHooks& hooks_;
  std::optional<Folder> folder_;
  std::vector<RobustnessKey> keys_;
  std::vector<std::optional<RobustnessRun>> runs_;  // one a key
  std::deque<std::size_t> waiting_;
  std::list<Active> active_;
  bool stopping_ = false;
};

}  // namespace

void check(const RobustnessOptions& options) {
  if (options.seeds < 1 || !(options.total_motion > 0) || !(options.time_limit > 0))
    throw base::InputError("a robustness study needs seeds >= 1, a total motion > 0 and a time limit > 0");
  if (options.workers < 1)
    throw base::InputError("--workers " + std::to_string(options.workers) + " is not allowed; it has to be >= 1");
  constexpr long most_seeds = 1'000'000;
  if (options.seeds > most_seeds)
    throw base::InputError("--seeds " + std::to_string(options.seeds) + " is not allowed; at most " +
                           std::to_string(most_seeds));
  for (double step : options.steps)
    if (!(step > 0 && step <= options.total_motion))
      throw base::InputError("--steps-of " + base::to_text(step) +
                             " is not allowed; a step has to be > 0 and at most the " + "total motion, " +
                             base::to_text(options.total_motion));
  for (long spheres : options.spheres)
    for (double step : options.steps) options_of_run(options, {spheres, step, 1});
}

std::vector<RobustnessRun> run_robustness(const RobustnessOptions& options, const RobustnessHooks& hooks) {
  check(options);
  return Study(options, hooks).go();
}

}  // namespace multitracker
