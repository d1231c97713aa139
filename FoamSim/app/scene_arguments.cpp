#include "FoamSim/app/scene_arguments.h"

#include <spdlog/spdlog.h>

#include <cmath>

#include "Base/error.h"

namespace foamsim::app {

void SceneArguments::add_to(CLI::App& command, bool with_area) {
  command.add_option("scene", scene,
                     "a built-in scene, a .toml scene file, a reference option file (.txt), or a mesh file");
  if (with_area) command.add_option("--area", area, "area strategy (see 'foamsim effects')");
  command.add_option("--set", assignments, "key=value, or key+=word for lists; repeat for more (see 'foamsim scenes')")
      ->type_size(1)
      ->allow_extra_args(false);
  command.add_option("--time", time, "stop at this simulated time");
  command.add_option("--steps", steps, "stop after this many steps");
  command.add_flag("--until-rest", until_rest, "stop when the surface is at rest");
  command.add_option("--out", out, "folder for the output (default: out/SCENE)");
  command.add_flag("--force", force, "replace a run that the folder holds");
  command.add_option("--threads", threads, "number of threads (default: all cores); results do not depend on it");
  command.add_option("--seed", seed, "seed of everything random");
  command.add_flag("--quiet", quiet, "print nothing but errors");
  command.add_flag("--explain", explain, "print what is active and what each stage costs");
}

Scene SceneArguments::load() const {
  Scene loaded = load_scene(scene);
  for (const std::string& assignment : assignments) loaded.options.set_assignment(assignment, "--set");
  if (!area.empty()) loaded.options.set("area", area, "--area");
  if (seed) loaded.options.set("seed", *seed, "--seed");
  validate(loaded);
  for (const std::string& note : loaded.notes)
    if (!quiet) spdlog::warn("{}", note);
  return loaded;
}

StopAt SceneArguments::stop() const {
  if (time && !(std::isfinite(*time) && *time >= 0)) throw base::InputError("--time has to be a finite number >= 0");
  if (steps && *steps < 0) throw base::InputError("--steps has to be a whole number >= 0");
  if (threads < 0) throw base::InputError("--threads has to be a whole number >= 1");
  return {time, steps, until_rest};
}

}  // namespace foamsim::app
