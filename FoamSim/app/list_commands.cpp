#include <cstdio>

#include "FoamSim/app/commands.h"
#include "FoamSim/effects/registry.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/scene_registry.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"

namespace foamsim::app {
namespace {

void print_option(const base::OptionSpec& spec) {
  std::printf("  %-18s %s (default %s)\n", spec.key.c_str(), spec.summary.c_str(),
              base::to_text(spec, spec.default_value).c_str());
}

void print_scenes(const Catalogue& catalogue) {
  std::printf("built-in scenes (foamsim run NAME) and their own options:\n");
  for (const SceneEntry& entry : catalogue.scenes) {
    std::printf("%s: %s", entry.name.c_str(), entry.summary.c_str());
    for (const auto& [key, value] : entry.defaults)
      std::printf("; default %s=%s", key.c_str(), base::to_text(value).c_str());
    std::printf("\n");
    for (const base::OptionSpec& spec : entry.options) print_option(spec);
  }
  std::printf("\noptions of every scene (--set key=value, or in a .toml file):\n");
  for (const base::OptionSpec& spec : common_option_specs(catalogue))
    if (spec.owner.kind.empty() || !spec.words.empty()) print_option(spec);
  std::printf("options of the effects and of what else is chosen by name: see 'foamsim effects'\n");
}

template <class Entry>
void print_models(const base::Registry<Entry>& registry) {
  for (const Entry& entry : registry) {
    std::printf("%s: %s\n", entry.name.c_str(), entry.summary.c_str());
    for (const base::OptionSpec& spec : entry.options) print_option(spec);
  }
}

void print_effects(const Catalogue& catalogue) {
  std::printf("effects (--set effects=a,b or effects+=a), in the order in which they act:\n");
  print_models(catalogue.effects);
  std::printf("\narea strategies (--area NAME):\n");
  print_models(catalogue.sheet.areas);
  std::printf("\npressure schemes (--set pressure=NAME):\n");
  print_models(catalogue.sheet.pressures);
  std::printf("\nvelocity sums (--set velocity=NAME):\n");
  print_models(catalogue.sheet.velocities);
  std::printf("\ndynamics (--set dynamics=NAME):\n");
  print_models(catalogue.dynamics);
  std::printf("\nintegrators (--set integrator=NAME):\n");
  print_models(catalogue.integrators);
  std::printf("\nconstraints (--set constraints=a,b; empty: none):\n");
  print_models(catalogue.constraints);
}

}  // namespace

void add_list_commands(base::Command& root, const Program& program) {
  root.add_command("scenes", "list the built-in scenes and their options").set_action([&program] {
    print_scenes(*program.catalogue);
    return exit_done;
  });
  root.add_command("effects", "list the effects, their options, and the area strategies").set_action([&program] {
    print_effects(*program.catalogue);
    return exit_done;
  });
}

}  // namespace foamsim::app
