#include "FoamSim/app/manual.h"

#include "FoamSim/scenes/scene.h"

namespace foamsim::app {
namespace {

using Section = base::Manual::Section;

template <class Entries>
Section section_of(const std::string& title, const Entries& entries) {
  Section section{title, {}};
  for (const auto& entry : entries) section.entries.emplace_back(entry.name, entry.summary);
  return section;
}

Section exit_status() {
  return {
      "exit status",
      {{"0", "done"},
       {"2", "bad input, or a folder that cannot be written to or in which another run works; nothing is left behind"},
       {"3", "the simulation could not go on; the last good state is saved and named; of a sweep: runs failed"},
       {"4", "the disk is full or has failed; a run goes on with --resume when there is room"},
       {"5", "sweep: some runs are still to come"},
       {"130, 143, 129", "ended by Ctrl-C, SIGTERM, SIGHUP after the step was finished and saved; how view ends"}}};
}

Section files() {
  return {"files",
          {{".run.lock", "while a run works there: by which process, on which machine"},
           {"run.json", "what was run, every option as used, times by stage, how it ended"},
           {"metrics.csv, volumes.csv", "a row a step"},
           {"events.csv", "every change of topology"},
           {"frames/*.ply", "surfaces"},
           {"checkpoint.cbor", "from which --resume goes on, to the same bits"},
           {"stats/", "what foamsim stats counts of the frames"},
           {"surface.pvd, vtp/", "for ParaView, with --set vtp=true"}}};
}

}  // namespace

base::Manual manual(const Catalogue& catalogue) {
  return {
      "Simulates soap films and foams as vortex sheets on a tracked surface. A run's folder holds the files named "
      "below.\n\nA scene is a built-in one, a .toml file that names one and sets options, a mesh file, or an option "
      "file of the reference program.",
      {section_of("scenes", catalogue.scenes), section_of("effects", catalogue.effects),
       section_of("area strategies", catalogue.sheet.areas), section_of("pressure schemes", catalogue.sheet.pressures),
       section_of("velocity sums", catalogue.sheet.velocities), section_of("dynamics", catalogue.dynamics),
       section_of("integrators", catalogue.integrators), section_of("constraints", catalogue.constraints),
       Section{"option keys (--set key=value, or in a .toml file)", base::manual_entries(all_option_specs(catalogue))},
       exit_status(), files(), Section{"environment", {{"NO_COLOR", "when set, messages are not coloured"}}}}};
}

}  // namespace foamsim::app
