#include "MultiTracker/app/manual.h"

#include "MultiTracker/scenes/scene.h"

namespace multitracker::app {

using Section = base::Manual::Section;

base::Manual manual() {
  base::Manual manual{
      "Moves a tracked surface of many regions by prescribed flows, growth and mean curvature: the "
      "surface tracker's classical scenes.",
      {Section{"scenes", {}}}};
  for (const SceneEntry& entry : scene_entries()) manual.sections[0].entries.emplace_back(entry.name, entry.summary);
  manual.sections.push_back({"option keys of every scene", base::manual_entries(common_option_specs())});
  for (const SceneEntry& entry : scene_entries())
    if (!entry.options.empty())
      manual.sections.push_back({"option keys of " + std::string(entry.name), base::manual_entries(entry.options)});
  manual.sections.push_back(
      {"exit status",
       {{"0", "done"},
        {"2", "bad input, or a folder that cannot be written to or in which another run works"},
        {"3", "the surface could not be moved on; the last good state is saved and named"},
        {"4", "the disk is full or has failed; a run goes on with --resume when there is room"},
        {"130, 143, 129", "ended by Ctrl-C, SIGTERM, SIGHUP after the step was finished and saved"}}});
  return manual;
}

}  // namespace multitracker::app
