#pragma once

#include <string>
#include <vector>

#include "FoamSim/web/frame_pack.h"
#include "FoamSim/web/run_contents.h"

namespace foamsim::web {

/// What of a frame is sent, and how exactly.
struct FrameOptions {
  std::vector<std::string> fields = {};  ///< names; empty: all; {"none"}: none
  Precision precision = Precision::quantised;
};

/// A frame that is ready to be sent.
struct LoadedFrame {
  std::string packed;   ///< `pack_frame`, compressed by gzip
  std::string bubbles;  ///< `bubbles_json`
  std::size_t triangles = 0;
};

/// Reads, measures and packs a frame. Throws base::InputError where a field does not exist, and what the readers of
/// meshes throw.
LoadedFrame load_frame(const RunFrame& frame, const FrameOptions& options);

}  // namespace foamsim::web
