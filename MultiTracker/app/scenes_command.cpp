#include <cstdio>
#include <memory>

#include "MultiTracker/app/commands.h"
#include "MultiTracker/scenes/scene.h"

namespace multitracker::app {
namespace {

void print_option(const base::OptionSpec& spec, const base::OptionValue& value) {
  std::printf("  %-28s %s (default %s)\n", spec.key.c_str(), spec.summary.c_str(), base::to_text(spec, value).c_str());
}

void print_all() {
  std::printf("scenes (multitracker run NAME):\n");
  for (const SceneEntry& entry : scene_entries()) {
    std::printf("%-12s %s\n", entry.name.data(), entry.summary.data());
    for (const base::OptionSpec& spec : entry.options) print_option(spec, spec.default_value);
  }
  std::printf("\noptions of every scene (--set key=value); 'multitracker scenes NAME' shows the defaults of one:\n");
  for (const base::OptionSpec& spec : common_option_specs()) print_option(spec, spec.default_value);
}

void print_one(const SceneEntry& entry) {
  std::printf("%s: %s\n", entry.name.data(), entry.summary.data());
  const base::OptionSet options = options_of(entry);
  for (const base::OptionSpec& spec : options.specs()) print_option(spec, options.value(spec.key));
}

}  // namespace

void add_scenes_command(base::Command& root, const Program&) {
  base::Command& command = root.add_command("scenes", "list the scenes and the keys of --set");
  auto name = std::make_shared<std::string>();
  command.add(
      {.name = "scene", .target = name.get(), .help = "only this one, with its defaults", .names = scene_names()});
  command.set_action([name] {
    if (name->empty())
      print_all();
    else
      print_one(scene_by_name(*name));
    return exit_done;
  });
}

}  // namespace multitracker::app
