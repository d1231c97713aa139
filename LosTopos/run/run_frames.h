#pragma once

#include <filesystem>
#include <vector>

namespace lostopos::run {

/// A frame of a run that was made.
struct RunFrame {
  long step = 0;
  double time = 0;  ///< T
  std::filesystem::path file;
};

/// The frames of a run's folder in the order of their steps: of one that is going on, those that are there. Throws
/// base::InputError, one line, where the folder is none of a run, has no frames, or lacks some that run.json says it
/// has: those of every `frame_every` steps up to the last, and the last.
std::vector<RunFrame> run_frames(const std::filesystem::path& run);

}  // namespace lostopos::run
