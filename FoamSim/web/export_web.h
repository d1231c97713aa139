#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "FoamSim/web/load_frame.h"

namespace foamsim::web {

struct ExportOptions {
  FrameOptions frames = {};
  long every = 1;  ///< of the run's frames every n-th, and the last one
};

/// What an export tells while it works.
struct ExportHooks {
  /// Before anything is written: about how many bytes the file will have, and of how many frames.
  std::function<void(std::uintmax_t bytes, std::size_t frames)> begin = {};
  /// After each frame.
  std::function<void(std::size_t done, std::size_t of)> frame_done = {};
  std::function<bool()> interrupted = {};  ///< asked before each frame
};

struct ExportOutcome {
  std::size_t frames = 0;
  std::uintmax_t bytes = 0;
};

/// Writes a run as one file for a browser: the page with its mark replaced by the run's data. The file appears whole
/// or not at all. Throws base::InputError for what cannot be used of the run, the page or the options, base::FileError,
/// base::DiskError, base::Interrupted.
ExportOutcome export_web(const std::filesystem::path& run, const std::filesystem::path& file, std::string_view page,
                         const ExportOptions& options, const ExportHooks& hooks);

}  // namespace foamsim::web
