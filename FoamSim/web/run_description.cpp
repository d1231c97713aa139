#include "FoamSim/web/run_description.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "FoamSim/version.h"

namespace foamsim::web {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t most_rows = 1000, most_events = 2000, most_volumes = 200000;

ordered_json number_or_nothing(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

// By column, so that those that are empty throughout can be left out.
ordered_json metrics_json(const NumberTable& table) {
  ordered_json columns = ordered_json::object();
  const std::vector<std::size_t> rows = spread_indices(table.rows.size(), most_rows);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    ordered_json values = ordered_json::array();
    bool any = false;
    for (std::size_t r : rows) {
      any = any || std::isfinite(table.rows[r][c]);
      values.push_back(number_or_nothing(table.rows[r][c]));
    }
    if (any) columns[table.columns[c]] = std::move(values);
  }
  return columns;
}

// {"steps": [...], "volumes": {"1": [...], ...}}
ordered_json volumes_json(const NumberTable& table) {
  const int step_column = table.column("step"), region = table.column("region"), volume = table.column("volume");
  ordered_json result = {{"steps", ordered_json::array()}, {"volumes", ordered_json::object()}};
  if (step_column < 0 || region < 0 || volume < 0) return result;
  std::map<long, std::map<long, double>> by_step;
  std::map<long, bool> regions;
  for (const std::vector<double>& row : table.rows) {
    const long number = static_cast<long>(row[static_cast<std::size_t>(region)]);
    if (number <= 0) continue;
    regions[number] = true;
    by_step[static_cast<long>(row[static_cast<std::size_t>(step_column)])][number] =
        row[static_cast<std::size_t>(volume)];
  }
  std::vector<long> steps;
  steps.reserve(by_step.size());
  for (const auto& [step, volumes] : by_step) steps.push_back(step);
  const std::size_t most = std::clamp<std::size_t>(most_volumes / std::max<std::size_t>(1, regions.size()), 2, 500);
  for (std::size_t i : spread_indices(steps.size(), most)) {
    result["steps"].push_back(steps[i]);
    const std::map<long, double>& volumes = by_step.at(steps[i]);
    for (const auto& [number, unused] : regions) {
      const auto found = volumes.find(number);
      result["volumes"][std::to_string(number)].push_back(found == volumes.end() ? ordered_json(nullptr)
                                                                                 : number_or_nothing(found->second));
    }
  }
  return result;
}

}  // namespace

std::string describe_run(const RunContents& run, const std::map<long, std::string>& bubbles) {
  ordered_json value = {{"format", 1},
                        {"program", "foamsim " + std::string(version)},
                        {"scene", run.scene},
                        {"command", run.command},
                        {"ended", run.ended},
                        {"frames", ordered_json::array()},
                        {"metrics", metrics_json(run.metrics)},
                        {"volumes", volumes_json(run.volumes)},
                        {"events", ordered_json::array()},
                        {"bubbles", ordered_json::object()}};
  for (const RunFrame& frame : run.frames) value["frames"].push_back({{"step", frame.step}, {"time", frame.time}});
  for (std::size_t i : spread_indices(run.events.size(), most_events)) {
    const RunEvent& event = run.events[i];
    value["events"].push_back(
        {{"step", event.step}, {"time", event.time}, {"kind", event.kind}, {"regions", event.regions}});
  }
  for (const auto& [step, list] : bubbles) value["bubbles"][std::to_string(step)] = ordered_json::parse(list);
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace foamsim::web
