#include "FoamSim/run/checkpoint.h"

#include <optional>

#include "Base/error.h"
#include "Base/options/options_json.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/state_json.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using nlohmann::json;

namespace {

json topology_json(const TopologyTotals& t) {
  return {t.snaps, t.edge_merges, t.separations, t.region_collapses, t.cancelled_triangles};
}

TopologyTotals topology_from(const json& value) {
  const auto counts = value.get<std::array<std::size_t, 5>>();
  return {counts[0], counts[1], counts[2], counts[3], counts[4]};
}

json volumes_json(const std::vector<lostopos::RegionVolume>& volumes) {
  json list = json::array();
  for (const auto& [region, volume] : volumes) list.push_back({region.index(), volume});
  return list;
}

// What the last step measured, and a simulation cannot know without doing it again.
json last_json(const Metrics& last) {
  return {{"kinetic_energy", last.kinetic_energy},
          {"potential_energy", last.potential_energy},
          {"impulse", {last.impulse.x(), last.impulse.y(), last.impulse.z()}},
          {"impulse_scale", last.impulse_scale},
          {"motion_fraction", last.motion_fraction}};
}

lostopos::Vec3 vector_from(const json& value) {
  const auto x = value.get<std::array<double, 3>>();
  return {x[0], x[1], x[2]};
}

StepReport last_from(const json& value) {
  StepReport last;
  last.kinetic_energy = value.at("kinetic_energy");
  last.potential_energy = value.at("potential_energy");
  last.impulse = vector_from(value.at("impulse"));
  last.impulse_scale = value.at("impulse_scale");
  last.motion_fraction = value.at("motion_fraction");
  return last;
}

json quiet_json(const std::deque<RestDetector::Sample>& quiet) {
  json list = json::array();
  for (const auto& [time, angle] : quiet) list.push_back({time, angle});
  return list;
}

Checkpoint checkpoint_from(const json& value) {
  Scene scene{value.at("scene"), value.at("mesh_file"), base::OptionSet(scene_option_specs()), {}};
  base::options_from_json(value.at("options"), scene.options);
  Checkpoint checkpoint{.scene = std::move(scene),
                        .mesh = SurfaceMesh::from_state(lostopos::mesh_state_from_json(value.at("mesh"))),
                        .step = value.at("step"),
                        .topology = topology_from(value.at("topology")),
                        .resolution = value.at("resolution"),
                        .start = {{}, vector_from(value.at("start_centroid"))},
                        .last = last_from(value.at("last")),
                        .quiet = {}};
  for (const json& entry : value.at("start_volumes"))
    checkpoint.start.volumes.push_back({Region(entry.at(0).get<std::uint32_t>()), entry.at(1)});
  for (const json& entry : value.at("quiet")) checkpoint.quiet.push_back({entry.at(0), entry.at(1)});
  return checkpoint;
}

}  // namespace

json checkpoint_content(const Scene& scene, const Simulation& simulation, const StartOfRun& start, const Metrics& last,
                        const std::deque<RestDetector::Sample>& quiet) {
  return {{"scene", scene.name},
          {"mesh_file", scene.mesh_file},
          {"options", base::options_to_json(scene.options)},
          {"step", simulation.steps()},
          {"topology", topology_json(simulation.topology_totals())},
          {"resolution", simulation.resolution()},
          {"start_volumes", volumes_json(start.volumes)},
          {"start_centroid", {start.centroid.x(), start.centroid.y(), start.centroid.z()}},
          {"last", last_json(last)},
          {"quiet", quiet_json(quiet)},
          {"mesh", lostopos::to_json(simulation.mesh().state())}};
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  std::optional<Checkpoint> checkpoint;
  lostopos::run::read_checkpoint(file, checkpoint_format(),
                                 [&](const json& content) { checkpoint = checkpoint_from(content); });
  return std::move(*checkpoint);
}

Simulation resume(Checkpoint& checkpoint) try {
  // The attributes of the checkpoint wait in the mesh for those of the simulation.
  Simulation simulation = make_simulation(checkpoint.scene, std::move(checkpoint.mesh), checkpoint.resolution, {});
  simulation.set_steps(checkpoint.step);
  simulation.set_topology_totals(checkpoint.topology);
  return simulation;
} catch (const lostopos::MeshError& problem) {
  throw base::InputError(std::string("it is not a whole checkpoint: ") + problem.what());
}

}  // namespace foamsim
