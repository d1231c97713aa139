#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/run/run.h"

namespace foamsim {

/// How far to run: the first of these that is reached; without steps and until_rest the scene's time.
struct StopAt {
  std::optional<double> time;  ///< simulated time, T
  std::optional<long> steps;   ///< steps in all, counted from the scene's start
  bool until_rest = false;     ///< see RestDetector; gives up after rest_patience characteristic times
};

struct RunSettings {
  std::filesystem::path out;
  bool force = false;  ///< replace a run that `out` holds
  std::filesystem::path
      resume;  ///< go on from this checkpoint (or the one in this folder); empty: from the scene's start
  StopAt stop;
  std::string command;  ///< the command line, for run.json
  bool write = true;    ///< false: nothing is written, as where another process writes the same run
};

using RunEnd = lostopos::run::End;

struct RunOutcome {
  RunEnd end = RunEnd::finished;
  std::string message;  ///< why it failed, or what to know about the end
  long first_step = 0;
  double dt = 0;  ///< T
  Metrics start, last;
  lostopos::Vec3 start_centroid = lostopos::Vec3::Zero();
  base::StageTimes times;
  lostopos::RemeshStatistics remesh;  ///< summed over all steps
  lostopos::MoveStatistics move;
  bool topology_enabled = false;
  lostopos::TopologyStatistics topology;  ///< without the events, which are in events.csv
  double wall_seconds = 0;
  std::filesystem::path directory, last_frame, checkpoint;
};

/// What the caller of a run hears and may say while it goes on.
struct RunHooks {
  std::function<void(long step, double time, double fraction_done)> progress;  ///< after every step
  std::function<bool()> interrupted;                                           ///< asked before every step
  /// Asked within steps, and while the start is made, too, often: cheap, and not by calls that are collective. A step
  /// that is interrupted is undone.
  std::function<bool()> interrupted_within = {};
  std::function<void(const std::string&)> warn = {};     ///< what to know before the first step
  std::function<void(long done, long of)> relaxed = {};  ///< after every step towards a relaxed start
  /// Before the first step, where the run may take over half of its memory_limit; twice, when that is known before
  /// there is a surface.
  std::function<void()> large = {};
};

/// The options' bound on --until-rest, in characteristic times √(R³/σ) of the mean bubble.
inline constexpr double rest_patience = 500;

/// Runs a scene and writes its folder (run.json, metrics.csv, volumes.csv, events.csv where the topology may change,
/// frames, checkpoint). A simulation that cannot go on, or an interruption, ends the run with the last good state
/// saved; base::InputError (bad scene, folder or checkpoint, a surface or resolution that check_start refuses, more
/// steps than can be counted, more memory than the option memory_limit) is thrown, before anything is written where
/// that is possible, base::DiskError for a full disk, and base::Interrupted when the start was interrupted, before
/// anything was written.
RunOutcome run_scene(const Scene& scene, const RunSettings& settings, const RunHooks& hooks = {});

}  // namespace foamsim
