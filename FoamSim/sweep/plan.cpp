#include "FoamSim/sweep/plan.h"

#include <cctype>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/sweep/stable_hash.h"

namespace foamsim::sweep {
namespace {

constexpr std::size_t longest_name = 120;  // file systems take 255 bytes

std::string assignment(const Axis& axis, const std::string& value) {
  return axis.key + "=" + value;
}

std::string name_of(const Grid& grid, const std::vector<std::string>& values) {
  std::string exact, name;
  bool lossy = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    exact += assignment(grid.axes[i], values[i]) + "\n";
    name += (i > 0 ? "_" : "") + grid.axes[i].key + "=";
    for (const char c : values[i]) {
      const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_';
      lossy = lossy || !(plain || c == ',');
      name += plain ? c : c == ',' ? '+' : '-';
    }
  }
  if (!lossy && name.size() <= longest_name) return name;
  return name.substr(0, longest_name) + "-" + stable_hash(exact);
}

std::vector<std::string> study_arguments(const Grid& grid, const PlannedRun& run) {
  std::vector<std::string> arguments{"study", grid.study};
  for (std::size_t i = 0; i < grid.axes.size(); ++i)
    arguments.insert(arguments.end(), {"--" + grid.axes[i].key, run.values[i]});
  arguments.insert(arguments.end(), grid.fixed.begin(), grid.fixed.end());
  return arguments;
}

}  // namespace

PlannedRun planned_run(const Grid& grid, std::vector<std::string> values) {
  std::string name = name_of(grid, values);
  return {std::move(name), std::move(values)};
}

std::vector<PlannedRun> plan_runs(const Grid& grid) {
  const std::size_t count = count_runs(grid);
  if (count > most_runs) throw base::InputError("a sweep can have " + std::to_string(most_runs) + " runs at most");
  std::vector<PlannedRun> runs;
  runs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    std::vector<std::string> values(grid.axes.size());
    for (std::size_t axis = grid.axes.size(); axis-- > 0;) {
      values[axis] = grid.axes[axis].values[rest % grid.axes[axis].values.size()];
      rest /= grid.axes[axis].values.size();
    }
    runs.push_back(planned_run(grid, std::move(values)));
  }
  return runs;
}

std::string table_of_run(const Grid& grid) {
  return grid.study.empty() ? "metrics.csv" : grid.study + ".csv";
}

std::vector<std::string> stop_arguments(const Grid& grid) {
  std::vector<std::string> arguments;
  if (grid.time) arguments.insert(arguments.end(), {"--time", base::to_text(*grid.time)});
  if (grid.steps) arguments.insert(arguments.end(), {"--steps", std::to_string(*grid.steps)});
  if (grid.until_rest) arguments.emplace_back("--until-rest");
  return arguments;
}

std::vector<std::string> run_arguments(const Grid& grid, const PlannedRun& run) {
  if (!grid.study.empty()) return study_arguments(grid, run);
  std::vector<std::string> arguments{"run", grid.scene};
  for (const std::string& fixed : grid.fixed) arguments.insert(arguments.end(), {"--set", fixed});
  for (std::size_t i = 0; i < grid.axes.size(); ++i)
    arguments.insert(arguments.end(), {"--set", assignment(grid.axes[i], run.values[i])});
  const std::vector<std::string> stop = stop_arguments(grid);
  arguments.insert(arguments.end(), stop.begin(), stop.end());
  return arguments;
}

void require_valid(const Grid& grid, const std::vector<PlannedRun>& runs, std::shared_ptr<const Catalogue> catalogue) {
  Scene common = load_scene(grid.scene, std::move(catalogue));
  for (const std::string& fixed : grid.fixed) common.options.set_assignment(fixed, "[options]");
  for (const PlannedRun& run : runs) {
    Scene scene = common;
    for (std::size_t i = 0; i < grid.axes.size(); ++i)
      scene.options.set_assignment(assignment(grid.axes[i], run.values[i]), "[sweep]");
    try {
      validate(scene);
    } catch (const base::InputError& error) {
      throw base::InputError("run " + run.name + ": " + error.what());
    }
  }
}

}  // namespace foamsim::sweep
