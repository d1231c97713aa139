#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <string>

#include "FoamSim/web/load_frame.h"
#include "FoamSim/web/run_contents.h"
#include "FoamSim/web/server/request_check.h"
#include "FoamSim/web/viewer_page.h"

namespace foamsim::web {

/// What the server of a run has to give, by path: "" the viewer's page, "run.json" the run's description as it is now,
/// "frame/STEP" a packed frame. Reads the run's folder and nothing else, and writes nothing.
class RunPages {
 public:
  /// Throws base::InputError where the folder is not a run's, or a field does not exist in its first frame.
  RunPages(std::filesystem::path folder, std::string_view page, FrameOptions options);

  /// 404 for other paths, 500 with a line for a run or frame that cannot be read (any more).
  WebAnswer answer(const std::string& path);

 private:
  struct KeptFrame {
    long step;
    std::filesystem::file_time_type written;
    std::string packed;
  };

  std::string frame(long step);

  std::filesystem::path folder_;
  FrameOptions options_;
  PageParts page_;
  RunContents run_;
  std::map<long, std::string> bubbles_;  // of the frames that have been read
  std::list<KeptFrame> kept_;            // the latest first
};

}  // namespace foamsim::web
