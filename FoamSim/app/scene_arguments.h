#pragma once

#include <string>
#include <vector>

#include "Base/console/command.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/run/run.h"

namespace foamsim::app {

/// The arguments by which a user names a scene, changes its options and says how far it runs.
struct SceneArguments {
  std::string scene;
  std::vector<std::string> assignments;  // key=value
  std::string area, fields, out;
  std::optional<double> time;
  std::optional<long> steps, seed;
  bool until_rest = false, force = false, quiet = false, explain = false;
  int threads = 0;

  /// `with_area`: also take --area.
  void add_to(base::Command& command, const Program& program, bool with_area);
  /// The scene with all of it applied; validated (see validate for `also_used`).
  Scene load(const Program& program, std::span<const std::string> also_used = {}) const;
  StopAt stop() const;
};

}  // namespace foamsim::app
