#include "FoamSim/run/scene_motion.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/metrics/metrics_csv.h"
#include "FoamSim/run/picture_fields.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/run/events_csv.h"

namespace foamsim {

using lostopos::run::Table;

SceneMotion::Beginning SceneMotion::beginning_of(const Scene& scene, const RelaxationProgress& progress,
                                                 const base::Interruption& interruption) {
  Simulation simulation = make_simulation(scene, progress, interruption);
  StartOfRun start{lostopos::closed_region_volumes(simulation.mesh()), lostopos::surface_centroid(simulation.mesh())};
  return {scene, std::move(simulation), std::move(start)};
}

SceneMotion::Beginning SceneMotion::beginning_of(Checkpoint checkpoint, const base::Interruption& interruption) {
  Simulation simulation = resume(checkpoint, interruption);
  std::optional<StepReport> before;
  if (checkpoint.state.steps > 0) before = checkpoint.last;
  return {std::move(checkpoint.scene), std::move(simulation), std::move(checkpoint.start), std::move(before),
          std::move(checkpoint.quiet)};
}

SceneMotion::Beginning SceneMotion::beginning_of(const std::filesystem::path& checkpoint,
                                                 const std::shared_ptr<const Catalogue>& catalogue,
                                                 const base::Interruption& interruption) {
  std::optional<Beginning> beginning;
  lostopos::run::read_checkpoint(checkpoint, checkpoint_format(), [&](const nlohmann::json& content) {
    beginning.emplace(beginning_of(checkpoint_from(content, catalogue), interruption));
  });
  return std::move(*beginning);
}

SceneMotion::SceneMotion(Beginning beginning)
    : SimulationMotion(std::move(beginning.simulation), beginning.start.volumes, beginning.before),
      scene_(std::move(beginning.scene)),
      start_(std::move(beginning.start)),
      rest_(characteristic_time(start_.volumes, scene_.options.number("sigma")), std::move(beginning.quiet)) {
  require_picture_fields(simulation(), scene_.options.words("fields"));
}

void SceneMotion::step() {
  SimulationMotion::step();
  if (steps() % scene_.options.whole("metrics_every") == 0) measure_now();
  at_rest_ = rest_.add(time(), report(), [this] { return junction_angles(mesh()).rms_deviation_deg; });
}

std::vector<Table> SceneMotion::tables() const {
  const long every = scene_.options.whole("metrics_every");
  std::vector<Table> all{{"metrics.csv", metrics_header(), every, [this] { return metrics_row(metrics()); }},
                         {"volumes.csv", volumes_header(), every, [this] { return volumes_rows(metrics()); }}};
  if (simulation().options().tracker.topology.enabled ||
      std::ranges::any_of(simulation().effects(), [](const auto& effect) { return effect->lets_burst(); }))
    all.push_back(lostopos::run::events_table(*this));
  return all;
}

lostopos::SurfaceData SceneMotion::frame() const {
  lostopos::SurfaceData data = SimulationMotion::frame();
  if (!simulation().options().follow_vertices) return data;
  lostopos::DataArray velocity = lostopos::vertex_array(mesh(), "motion").value();
  velocity.name = lostopos::velocity_array;
  velocity.unit = "L/T";
  for (double& value : velocity.values) value /= simulation().options().dt;
  data.vertex_arrays = {std::move(velocity), lostopos::vertex_array(mesh(), lostopos::vertex_id_array).value()};
  return data;
}

lostopos::SurfaceData SceneMotion::picture() const {
  // Not shared out among processes: the first one alone writes.
  const auto velocity = scene_.catalogue->sheet.velocities.find(scene_.options.word("velocity")).make({scene_.options});
  return picture_of(simulation(), {scene_.options.words("fields"), scene_.options.number("sigma"), *velocity});
}

lostopos::SurfaceData SceneMotion::record() const {
  lostopos::SurfaceData data = lostopos::from_mesh(mesh());
  lostopos::PairArray circulation{lostopos::rec_pair_array, {0}, {}};
  std::uint32_t number = 0;
  for (lostopos::Vertex v : mesh().vertices()) {
    for (const PairCirculation& pair : simulation().circulation().at(v))
      circulation.values.push_back({pair.pair.low, pair.pair.high, pair.value});
    circulation.offsets.push_back(circulation.values.size());
    if (lostopos::is_held(simulation().held()[v.index()])) data.held.push_back({number, mesh().position(v)});
    ++number;
  }
  data.pair_arrays.push_back(std::move(circulation));
  return data;
}

void SceneMotion::save(nlohmann::json& checkpoint) const {
  checkpoint = checkpoint_content(scene_, simulation(), start_, report(), rest_.quiet());
}

}  // namespace foamsim
