#include "MultiTracker/run/checkpoint.h"

#include <nlohmann/json.hpp>

#include "Base/json/checked_json.h"
#include "Base/options/options_json.h"
#include "LosTopos/mesh/state_json.h"

namespace multitracker {

using base::CheckedJson;
using nlohmann::json;

namespace {

json start_json(const Metrics& m) {
  return {{"vertices", m.vertices},
          {"triangles", m.triangles},
          {"regions", m.regions},
          {"area", m.area},
          {"shared_area", m.shared_area},
          {"air_area", m.air_area},
          {"junction_edges", m.junction_edges}};
}

Metrics start_from(const CheckedJson& value) {
  const auto count = [&value](const char* key) { return static_cast<std::size_t>(value.at(key).whole_number()); };
  Metrics start;
  start.vertices = count("vertices");
  start.triangles = count("triangles");
  start.regions = count("regions");
  start.area = value.at("area").finite_number();
  start.shared_area = value.at("shared_area").finite_number();
  start.air_area = value.at("air_area").finite_number();
  start.junction_edges = count("junction_edges");
  return start;
}

}  // namespace

json checkpoint_content(const Checkpoint& checkpoint) {
  const Origin& origin = checkpoint.origin;
  json value = {{"scene", origin.scene->name},
                {"mesh_file", origin.mesh_file},
                {"options", base::option_state_to_json(origin.options)},
                {"surface", lostopos::to_json(checkpoint.surface)},
                {"step", checkpoint.step},
                {"start", start_json(checkpoint.start)},
                {"start_volumes", json::array()}};
  if (origin.given) value["given"] = lostopos::to_json(*origin.given);
  for (const auto& [region, volume] : checkpoint.start_volumes)
    value["start_volumes"].push_back({region.index(), volume});
  return value;
}

Checkpoint checkpoint_from(const json& content) {
  constexpr std::int64_t most_steps = std::int64_t{1} << 53;
  const CheckedJson value(content, "");
  const SceneEntry& scene = scene_by_name(value.at("scene").text());
  Checkpoint checkpoint{
      .origin = {.scene = &scene, .options = options_of(scene), .mesh_file = value.at("mesh_file").text()},
      .surface = lostopos::mesh_state_from_json(value.at("surface").json()),
      .step = value.at("step").whole_number(0, most_steps),
      .start = start_from(value.at("start")),
      .start_volumes = {}};
  base::option_state_from_json(value.at("options").json(), checkpoint.origin.options);
  if (value.has("given")) checkpoint.origin.given = lostopos::mesh_state_from_json(value.at("given").json());
  for (const CheckedJson& entry : value.at("start_volumes").entries()) {
    const auto parts = entry.entries(2);
    checkpoint.start_volumes.push_back({lostopos::Region(parts[0].index()), parts[1].finite_number()});
  }
  return checkpoint;
}

}  // namespace multitracker
