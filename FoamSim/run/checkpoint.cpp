#include "FoamSim/run/checkpoint.h"

#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "Base/options/options_json.h"
#include "LosTopos/run/proportion.h"

namespace foamsim {

using base::CheckedJson;
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

lostopos::Vec3 vector_from(const CheckedJson& value) {
  const std::vector<double> x = value.finite_numbers(3);
  return {x[0], x[1], x[2]};
}

StepReport last_from(const CheckedJson& value) {
  StepReport last;
  last.kinetic_energy = value.at("kinetic_energy").finite_number();
  last.potential_energy = value.at("potential_energy").finite_number();
  last.impulse = vector_from(value.at("impulse"));
  last.impulse_scale = value.at("impulse_scale").finite_number();
  last.motion_fraction = value.at("motion_fraction").finite_number();
  return last;
}

json quiet_json(const std::deque<RestDetector::Sample>& quiet) {
  json list = json::array();
  for (const auto& [time, angle] : quiet) list.push_back({time, angle});
  return list;
}

// Two numbers an entry.
template <class Take>
void take_pairs(const CheckedJson& list, Take&& take) {
  for (const CheckedJson& entry : list.entries()) {
    const std::vector<CheckedJson> parts = entry.entries(2);
    take(parts[0], parts[1].finite_number());
  }
}

Scene scene_from(const CheckedJson& value, std::shared_ptr<const Catalogue> catalogue) {
  const std::string& mesh_file = value.at("mesh_file").text();
  Scene scene = mesh_file.empty() ? built_in_scene(value.at("scene").text(), std::move(catalogue))
                                  : mesh_scene(mesh_file, std::move(catalogue));
  base::option_state_from_json(value.at("options").json(), scene.options);
  return scene;
}

void require_fitting(const Checkpoint& checkpoint, const SurfaceMesh& mesh) {
  const base::OptionSet& options = checkpoint.scene.options;
  if (mesh.triangle_count() == 0) throw base::InputError("its surface has no triangles");
  const auto refuse = [](const char* what, double value, const std::string& why) {
    throw base::InputError(std::string("its ") + what + ", " + base::to_text(value) + ", is not " + why);
  };
  const double dt = options.number("dt"), resolution = options.number("resolution");
  if (dt > 0 && checkpoint.state.dt != dt) refuse("step", checkpoint.state.dt, "the dt of its options");
  if (resolution > 0 && checkpoint.resolution != resolution)
    refuse("resolution", checkpoint.resolution, "that of its options");
  lostopos::run::require_proportion(mesh, checkpoint.resolution, options.flag("remeshing.enabled"));
}

void require_circulation_of(const Simulation& simulation) {
  const SurfaceMesh& mesh = simulation.mesh();
  for (lostopos::Vertex v : mesh.vertices())
    if (!matches(simulation.circulation().at(v), mesh, v))
      throw base::InputError("vertex " + std::to_string(v.index()) +
                             " has the circulation of other films than those that meet there");
}

}  // namespace

json checkpoint_content(const Scene& scene, const Simulation& simulation, const StartOfRun& start,
                        const StepReport& last, const std::deque<RestDetector::Sample>& quiet) {
  return {{"scene", scene.name},
          {"mesh_file", scene.mesh_file},
          {"options", base::option_state_to_json(scene.options)},
          {"resolution", simulation.resolution()},
          {"start_volumes", volumes_json(start.volumes)},
          {"start_centroid", {start.centroid.x(), start.centroid.y(), start.centroid.z()}},
          {"last", last_json(last)},
          {"quiet", quiet_json(quiet)},
          {"state", to_json(simulation.state())}};
}

Checkpoint checkpoint_from(const json& content, std::shared_ptr<const Catalogue> catalogue) {
  const CheckedJson value(content, "");
  Checkpoint checkpoint{.scene = scene_from(value, std::move(catalogue)),
                        .state = simulation_state_from_json(value.at("state").json()),
                        .resolution = value.at("resolution").positive_number(),
                        .start = {{}, vector_from(value.at("start_centroid"))},
                        .last = last_from(value.at("last")),
                        .quiet = {}};
  take_pairs(value.at("start_volumes"), [&](const CheckedJson& region, double volume) {
    checkpoint.start.volumes.push_back({Region(region.index()), volume});
  });
  take_pairs(value.at("quiet"), [&](const CheckedJson& time, double angle) {
    checkpoint.quiet.push_back({time.finite_number(), angle});
  });
  return checkpoint;
}

Simulation resume(const Checkpoint& checkpoint, const base::Interruption& interruption) {
  SurfaceMesh mesh = SurfaceMesh::from_state(checkpoint.state.tracker);
  require_fitting(checkpoint, mesh);
  Simulation simulation = make_simulation(checkpoint.scene, std::move(mesh), checkpoint.resolution, {}, interruption);
  simulation.restore(checkpoint.state);
  require_circulation_of(simulation);
  return simulation;
}

}  // namespace foamsim
