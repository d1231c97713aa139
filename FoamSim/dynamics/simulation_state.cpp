#include "FoamSim/dynamics/simulation_state.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "FoamSim/dynamics/simulation.h"
#include "LosTopos/mesh/state_json.h"

namespace foamsim {

using nlohmann::json;

namespace {

// Up to here a double holds the number of a step, and its time.
constexpr std::int64_t most_steps = std::int64_t{1} << 53;
constexpr std::int64_t most_vertex_ids = std::int64_t{1} << 31;

json topology_json(const TopologyTotals& t) {
  return {{"snaps", t.snaps},
          {"edge_merges", t.edge_merges},
          {"separations", t.separations},
          {"region_collapses", t.region_collapses},
          {"cancelled_triangles", t.cancelled_triangles}};
}

TopologyTotals topology_from(const base::CheckedJson& value) {
  const auto count = [&value](const char* key) { return static_cast<std::size_t>(value.at(key).whole_number()); };
  return {.snaps = count("snaps"),
          .edge_merges = count("edge_merges"),
          .separations = count("separations"),
          .region_collapses = count("region_collapses"),
          .cancelled_triangles = count("cancelled_triangles")};
}

// What the models of one kind remember, those that remember nothing left out.
template <class Models>
json remembered(const Models& models) {
  json all = json::object();
  for (const auto& model : models)
    if (json own = model->state(); !own.is_null()) all[std::string(model->name())] = std::move(own);
  return all;
}

template <class Models>
void remind(const Models& models, const json& all, const char* kind) {
  for (const auto& entry : all.items())
    if (std::ranges::none_of(models, [&entry](const auto& model) { return model->name() == entry.key(); }))
      throw base::InputError(std::string("the state is of a simulation with the ") + kind + " '" + entry.key() +
                             "', which this one does not have");
  for (const auto& model : models) {
    const json own = all.value(std::string(model->name()), json());
    if (!own.is_null() || !model->state().is_null()) model->restore(own);
  }
}

}  // namespace

json to_json(const SimulationState& state) {
  return {{"steps", state.steps},
          {"dt", state.dt},
          {"vertex_ids", state.vertex_ids},
          {"topology", topology_json(state.topology)},
          {"surface", lostopos::to_json(state.tracker)},
          {"models", state.models ? *state.models : json::object()}};
}

SimulationState simulation_state_from_json(const json& json_value) {
  const base::CheckedJson value(json_value, "state");
  const base::CheckedJson models = value.at("models");
  for (const char* kind : {"effects", "constraints"})
    if (!models.at(kind).json().is_object()) models.at(kind).refuse("is not an object");
  (void)models.at("dynamics");
  return {.steps = value.at("steps").whole_number(0, most_steps),
          .dt = value.at("dt").positive_number(),
          .vertex_ids = value.at("vertex_ids").whole_number(0, most_vertex_ids),
          .topology = topology_from(value.at("topology")),
          .tracker = lostopos::mesh_state_from_json(value.at("surface").json()),
          .models = std::make_shared<const json>(models.json())};
}

SimulationState Simulation::state() const {
  SimulationState state;
  save(state);
  return state;
}

void Simulation::save(SimulationState& state) const {
  state.steps = steps_;
  state.dt = options_.dt;
  state.vertex_ids = vertex_ids_ ? vertex_ids_->given() : 0;
  state.topology = topology_totals_;
  tracker_->save(state.tracker);
  state.models = std::make_shared<const json>(json{{"effects", remembered(parts_.effects)},
                                                   {"constraints", remembered(parts_.constraints)},
                                                   {"dynamics", parts_.dynamics->state()}});
}

void Simulation::restore(const SimulationState& state) {
  const json none = json::object();
  const json& models = state.models ? *state.models : none;
  remind(parts_.effects, models.value("effects", none), "effect");
  remind(parts_.constraints, models.value("constraints", none), "constraint");
  parts_.dynamics->restore(models.value("dynamics", json()));
  tracker_->restore(state.tracker);
  if (vertex_ids_) vertex_ids_->set_given(state.vertex_ids);
  steps_ = state.steps;
  options_.dt = state.dt;
  topology_totals_ = state.topology;
  geometry_.update(tracker_->mesh(), solid());
}

}  // namespace foamsim
