#pragma once

#include <map>
#include <string>
#include <vector>

#include "FoamSim/web/run_contents.h"

namespace foamsim::web {

/// What the viewer knows of a run besides its surfaces, as JSON: scene, command, how it ended, steps and times of the
/// frames, metrics, volumes and events thinned out evenly to what a plot can show. `bubbles`: by step, `bubbles_json`
/// of the frames that have been read.
std::string describe_run(const RunContents& run, const std::map<long, std::string>& bubbles);

}  // namespace foamsim::web
