#include "MultiTracker/run/checkpoint.h"

#include <nlohmann/json.hpp>

#include "Base/options/options_json.h"
#include "LosTopos/mesh/state_json.h"

namespace multitracker {

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

Metrics start_from(const json& value) {
  Metrics start;
  start.vertices = value.at("vertices");
  start.triangles = value.at("triangles");
  start.regions = value.at("regions");
  start.area = value.at("area");
  start.shared_area = value.at("shared_area");
  start.air_area = value.at("air_area");
  start.junction_edges = value.at("junction_edges");
  return start;
}

Checkpoint checkpoint_from(const json& value) {
  const SceneEntry& scene = scene_by_name(value.at("scene").get<std::string>());
  Checkpoint checkpoint{.origin = {.scene = &scene, .options = options_of(scene), .mesh_file = value.at("mesh_file")},
                        .surface = lostopos::mesh_state_from_json(value.at("surface")),
                        .step = value.at("step"),
                        .start = start_from(value.at("start")),
                        .start_volumes = {}};
  base::options_from_json(value.at("options"), checkpoint.origin.options);
  if (value.contains("given")) checkpoint.origin.given = lostopos::mesh_state_from_json(value.at("given"));
  for (const json& entry : value.at("start_volumes"))
    checkpoint.start_volumes.push_back({lostopos::Region(entry.at(0).get<std::uint32_t>()), entry.at(1)});
  return checkpoint;
}

}  // namespace

json checkpoint_content(const Checkpoint& checkpoint) {
  const Origin& origin = checkpoint.origin;
  json value = {{"scene", origin.scene->name},
                {"mesh_file", origin.mesh_file},
                {"options", base::options_to_json(origin.options)},
                {"surface", lostopos::to_json(checkpoint.surface)},
                {"step", checkpoint.step},
                {"start", start_json(checkpoint.start)},
                {"start_volumes", json::array()}};
  if (origin.given) value["given"] = lostopos::to_json(*origin.given);
  for (const auto& [region, volume] : checkpoint.start_volumes)
    value["start_volumes"].push_back({region.index(), volume});
  return value;
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  std::optional<Checkpoint> checkpoint;
  lostopos::run::read_checkpoint(std::filesystem::is_directory(file) ? file / "checkpoint.cbor" : file,
                                 checkpoint_format(),
                                 [&](const json& content) { checkpoint = checkpoint_from(content); });
  return std::move(*checkpoint);
}

}  // namespace multitracker
