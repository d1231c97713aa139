#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "LosTopos/io/rec.h"
#include "LosTopos/run/checkpoint.h"
#include "LosTopos/run/motion.h"

namespace lostopos::run {

/// How far a motion runs.
struct Plan {
  long last_step = 0;  ///< counted from the start of the motion
  /// Asked after every step: the surface is at rest, and the run done. Where it is given, a run that comes to its last
  /// step has not come to rest.
  std::function<bool()> at_rest = {};
  /// Asked after every step: whether to stop early, for a reason that the caller knows.
  std::function<bool()> stop = {};
  /// Asked after every step: what is wrong with the surface, which ends the run as failed; empty: nothing.
  std::function<std::string()> defect = {};
};

/// What a run writes, and where.
struct Output {
  std::filesystem::path folder;  ///< empty: nothing is written
  bool force = false;            ///< replace a run that the folder holds
  /// The motion comes from the folder's own checkpoint: its tables and collection go on behind that step.
  bool go_on = false;
  long frame_every = 0;       ///< steps between frames; 0: the first and the last only
  long checkpoint_every = 0;  ///< steps between checkpoints; 0: not by steps
  /// Wall time between checkpoints, s, or longer where they would take more than 1% of it; 0: not by time. The end has
  /// one in any case.
  double checkpoint_seconds = 0;
  bool vtp = false;  ///< also write .vtp frames and surface.pvd
  /// Steps between the meshes that the reference programs write, from the start on, under the names that they have
  /// there: rec/mesh000000.rec, obj/mesh000000.obj (with normals), ...; 0: none.
  long rec_every = 0, obj_every = 0;
  long reference_frames = 1;                      ///< that one step is there, by which these files are numbered
  RecFlavour rec_flavour = RecFlavour::SoapFilm;  ///< of the .rec files
  CheckpointFormat checkpoint;
  std::function<void(nlohmann::ordered_json& run)> describe = {};  ///< how run.json begins
};

/// What the caller of a run hears and may say while it goes on.
struct Hooks {
  std::function<void(double fraction)> stepped = {};  ///< after every step, which is written by then
  std::function<bool()> interrupted = {};             ///< asked before every step
};

enum class End { finished, at_rest, not_at_rest, stopped, interrupted, failed };
/// "finished", "at rest", ...
const char* name(End end);

struct Outcome {
  End end = End::finished;
  std::string message;  ///< why it failed, or what to know about the end
  long first_step = 0;  ///< from which it went on
  StepWork work;        ///< summed over the run's steps
  double wall_seconds = 0;
  std::filesystem::path last_frame, checkpoint;  ///< the last good state; empty when not written
};

/// Runs a motion to its plan's end and writes the folder: frames, tables, checkpoints, run.json (from the start on).
/// A step that cannot be done, or an interruption, ends the run with the last good state saved. Throws
/// base::InputError for a folder that cannot be used or in which another run works, and base::DiskError when the disk
/// is full: what was written until then stays, or nothing of it when that happens at the start.
Outcome run_motion(Motion& motion, const Plan& plan, const Output& output, const Hooks& hooks = {});
/// The same with nothing written.
Outcome run_in_memory(Motion& motion, const Plan& plan, const Hooks& hooks = {});

/// The steps of length `dt` (T) that make up `time` (T), to the nearest. Throws base::InputError where they are more
/// than can be counted, with the longest time that can be asked for.
long steps_of(double time, double dt);

/// Throws base::InputError when so many steps are more than can be counted.
void require_countable(double steps, double dt);

}  // namespace lostopos::run
