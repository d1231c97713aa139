#include "FoamSim/app/scene_arguments.h"

#include <cmath>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "FoamSim/app/common_arguments.h"

namespace foamsim::app {

namespace {

// A folder is not a scene, unless it has a scene's name by chance; that of a run has what was probably meant.
void require_no_folder(const std::filesystem::path& path, const Program& program) {
  if (program.catalogue->scenes.has(path.string()) || !std::filesystem::is_directory(path)) return;
  const std::filesystem::path checkpoint = path / "checkpoint.cbor";
  if (!std::filesystem::exists(checkpoint))
    throw base::InputError(path.string() + " is a folder; a scene is a name or a file (see '" + program.name +
                           " scenes')");
  throw base::InputError(path.string() + " is the folder of a run; to go on with it: " + program.name +
                         " run --resume " + checkpoint.string());
}

}  // namespace

void SceneArguments::add_to(base::Command& command, const Program& program, bool with_area) {
  const Catalogue& catalogue = *program.catalogue;
  using Offers = base::Argument::Offers;
  command.add({.name = "scene",
               .target = &scene,
               .help = "a built-in scene, a .toml scene file, a reference option file (.txt), or a mesh file",
               .names = catalogue.scenes.names(),
               .offers = Offers::files});
  if (with_area)
    command.add({.name = "--area",
                 .target = &area,
                 .help = "area strategy (see 'foamsim effects')",
                 .names = catalogue.sheet.areas.names()});
  command.add({.name = "--fields",
               .target = &fields,
               .help = "what .vtp frames have, separated by commas (docs/output.md); writes such frames"});
  command.add({.name = "--set",
               .target = &assignments,
               .help = "key=value, or key+=word for lists; repeat for more (see 'foamsim scenes')",
               .list = base::Argument::List::words,
               .assigns = all_option_specs(catalogue)});
  command.add({.name = "--time", .target = &time, .help = "stop at this simulated time"});
  command.add({.name = "--steps", .target = &steps, .help = "stop after this many steps"});
  command.add({.name = "--until-rest", .target = &until_rest, .help = "stop when the surface is at rest"});
  command.add({.name = "--out",
               .target = &out,
               .help = "folder for the output (default: out/SCENE)",
               .offers = Offers::folders});
  command.add({.name = "--force", .target = &force, .help = "replace a run that the folder holds"});
  add_threads(command, threads);
  command.add({.name = "--seed", .target = &seed, .help = "seed of everything random"});
  add_quiet(command, quiet);
  command.add({.name = "--explain", .target = &explain, .help = "print what is active and what each stage costs"});
}

Scene SceneArguments::load(const Program& program, std::span<const std::string> also_used) const {
  require_no_folder(scene, program);
  Scene loaded = load_scene(scene, program.catalogue);
  for (const std::string& assignment : assignments) loaded.options.set_assignment(assignment, "--set");
  if (!area.empty()) loaded.options.set("area", area, "--area");
  if (!fields.empty()) loaded.options.set_assignment("fields=" + fields, "--fields");
  if (seed) loaded.options.set("seed", *seed, "--seed");
  validate(loaded, also_used);
  for (const std::string& note : loaded.notes)
    if (!quiet) base::print_warning(program.name, note);
  return loaded;
}

StopAt SceneArguments::stop() const {
  if (time && !(std::isfinite(*time) && *time >= 0)) throw base::InputError("--time has to be a finite number >= 0");
  if (steps && *steps < 0) throw base::InputError("--steps has to be a whole number >= 0");
  return {time, steps, until_rest};
}

}  // namespace foamsim::app
