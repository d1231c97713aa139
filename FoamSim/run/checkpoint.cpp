#include "FoamSim/run/checkpoint.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "Base/error.h"
#include "Base/options/options_json.h"
#include "LosTopos/error.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using nlohmann::json;

namespace {

json volumes_json(const std::vector<lostopos::RegionVolume>& volumes) {
  json list = json::array();
  for (const auto& [region, volume] : volumes) list.push_back({region.index(), volume});
  return list;
}

// What the last step measured, and a simulation cannot know without doing it again.
json last_json(const StepReport& last) {
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

Checkpoint checkpoint_from(const json& value, std::shared_ptr<const Catalogue> catalogue) {
  const std::string mesh_file = value.at("mesh_file");
  Scene scene = mesh_file.empty() ? built_in_scene(value.at("scene").get<std::string>(), std::move(catalogue))
                                  : mesh_scene(mesh_file, std::move(catalogue));
  base::options_from_json(value.at("options"), scene.options);
  Checkpoint checkpoint{.scene = std::move(scene),
                        .state = simulation_state_from_json(value.at("state")),
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

json checkpoint_content(const Scene& scene, const Simulation& simulation, const StartOfRun& start,
                        const StepReport& last, const std::deque<RestDetector::Sample>& quiet) {
  return {{"scene", scene.name},
          {"mesh_file", scene.mesh_file},
          {"options", base::options_to_json(scene.options)},
          {"resolution", simulation.resolution()},
          {"start_volumes", volumes_json(start.volumes)},
          {"start_centroid", {start.centroid.x(), start.centroid.y(), start.centroid.z()}},
          {"last", last_json(last)},
          {"quiet", quiet_json(quiet)},
          {"state", to_json(simulation.state())}};
}

Checkpoint read_checkpoint(const std::filesystem::path& file, std::shared_ptr<const Catalogue> catalogue) {
  std::optional<Checkpoint> checkpoint;
  lostopos::run::read_checkpoint(file, checkpoint_format(),
                                 [&](const json& content) { checkpoint = checkpoint_from(content, catalogue); });
  return std::move(*checkpoint);
}

Simulation resume(const Checkpoint& checkpoint, const base::Interruption& interruption) try {
  Simulation simulation = make_simulation(checkpoint.scene, SurfaceMesh::from_state(checkpoint.state.tracker),
                                          checkpoint.resolution, {}, interruption);
  simulation.restore(checkpoint.state);
  return simulation;
} catch (const lostopos::MeshError& problem) {
  throw base::InputError(std::string("it is not a whole checkpoint: ") + problem.what());
}

}  // namespace foamsim
