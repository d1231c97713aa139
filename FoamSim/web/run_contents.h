#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "FoamSim/web/run_tables.h"

namespace foamsim::web {

/// A saved surface of a run.
struct RunFrame {
  long step;
  double time;                        ///< T
  std::filesystem::path surface;      ///< frames/frame_N.ply
  std::filesystem::path with_fields;  ///< vtp/frame_N.vtp; empty where the run writes none
};

/// What a run's folder holds (docs/output.md), but for the surfaces themselves.
struct RunContents {
  std::string scene, command, ended;  ///< of run.json
  std::vector<RunFrame> frames;       ///< ascending by step; not empty
  NumberTable metrics, volumes;       ///< empty where the run has none
  std::vector<RunEvent> events;

  bool is_running() const { return ended == "running"; }
};

/// Reads a run's folder, also while the run goes on: what it has not finished writing is left out. Throws
/// base::InputError where the folder is no run's, has no frame, or lacks frames in the middle; base::FileError where it
/// cannot be read.
RunContents read_run(const std::filesystem::path& folder);

}  // namespace foamsim::web
