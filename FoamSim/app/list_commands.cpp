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
              base::to_text(spec.default_value).c_str());
}

void print_scenes() {
  std::printf("built-in scenes (foamsim run NAME):\n");
  for (const SceneEntry& entry : scene_entries()) {
    std::printf("  %-14s %s\n  %-14s %s", entry.name.data(), entry.summary.data(), "", entry.uses.data());
    for (const auto& [key, value] : entry.defaults)
      std::printf("; default %s=%s", key.data(), base::to_text(value).c_str());
    std::printf("\n");
  }
  std::printf("\noptions of every scene (--set key=value, or in a .toml file):\n");
  for (const base::OptionSpec& spec : scene_option_specs())
    if (spec.effect.empty()) print_option(spec);
  std::printf("options of the effects: see 'foamsim effects'\n");
}

void print_effects() {
  std::printf("effects (--set effects=a,b or effects+=a), in the order in which they act:\n");
  for (const EffectEntry& effect : effect_entries()) {
    std::printf("%s: %s\n", effect.name.data(), effect.summary.data());
    for (const base::OptionSpec& spec : effect.options) print_option(spec);
  }
  std::printf("\narea strategies (--area NAME):\n");
  for (const VertexAreaEntry& entry : vertex_area_strategies())
    std::printf("  %-14s %s\n", entry.name.data(), entry.summary.data());
}

}  // namespace

void add_list_commands(base::Command& root, const Program&) {
  root.add_command("scenes", "list the built-in scenes and their options").set_action([] {
    print_scenes();
    return exit_done;
  });
  root.add_command("effects", "list the effects, their options, and the area strategies").set_action([] {
    print_effects();
    return exit_done;
  });
}

}  // namespace foamsim::app
