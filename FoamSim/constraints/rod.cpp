#include "FoamSim/constraints/rod.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "FoamSim/constraints/border_chain.h"
#include "FoamSim/constraints/wire_transfer.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

void Rod::attach(lostopos::SurfaceTracker& tracker) {
  const SurfaceMesh& mesh = tracker.mesh();
  places_.emplace(tracker.mesh().add_vertex_attribute<std::int32_t>("rod", std::make_unique<WireTransfer>(), 0));
  velocities_.emplace(
      tracker.mesh().add_vertex_attribute<Vec3>("rod_velocity", lostopos::carry::copy, Vec3(Vec3::Zero())));
  // One that is on its way is put back by `restore`.
  if (std::ranges::any_of(places_->slots(), [](std::int32_t place) { return place != 0; })) return find_chain(mesh);
  const auto held = std::as_const(tracker).held().slots();
  const std::vector<Vertex> order = border_chain(mesh, held);
  for (std::size_t i = 0; i < order.size(); ++i) (*places_)[order[i]] = static_cast<std::int32_t>(i) + 1;
  std::vector<double> lengths;
  for (std::size_t i = 0; i + (options_.looped ? 0 : 1) < order.size(); ++i) {
    const Vertex next = order[(i + 1) % order.size()];
    lengths.push_back((mesh.position(next) - mesh.position(order[i])).norm());
    if (options_.looped && i + 1 == order.size() && !mesh.find_edge(order[i], next).valid())
      throw base::InputError("the rod is looped, but its ends, vertices " + std::to_string(order[i].index()) + " and " +
                             std::to_string(next.index()) + ", are not joined; give --set looped=false");
    if (!(lengths.back() > 0))
      throw base::InputError("the rod has no length between vertices " + std::to_string(order[i].index()) + " and " +
                             std::to_string(next.index()));
  }
  std::vector<char> fixed(order.size(), 0);
  if (options_.fixed)
    for (Vertex v : options_.fixed->of(mesh, held))
      if (const std::int32_t place = (*places_)[v]; place > 0) fixed[static_cast<std::size_t>(place) - 1] = 1;
  make_chain(std::move(lengths), std::move(fixed));
}

void Rod::find_chain(const SurfaceMesh& mesh) {
  std::vector<char> found;
  for (Vertex v : mesh.vertices()) {
    if (!(*velocities_)[v].allFinite())
      throw base::InputError("the velocity of the rod's vertex " + std::to_string(v.index()) + " is not finite");
    const std::int32_t place = (*places_)[v];
    if (place == 0) continue;
    if (place < 0 || static_cast<std::size_t>(place) > mesh.vertex_count())
      throw base::InputError("vertex " + std::to_string(v.index()) + " is at place " + std::to_string(place) +
                             " of the rod, which has none such");
    found.resize(std::max(found.size(), static_cast<std::size_t>(place)), 0);
    found[static_cast<std::size_t>(place) - 1] = 1;
  }
  if (std::ranges::find(found, 0) != found.end())
    throw base::InputError("the rod's vertices are not a chain: a place has none");
  fixed_.assign(found.size(), 0);
}

void Rod::make_chain(std::vector<double> lengths, std::vector<char> fixed) {
  fixed_ = std::move(fixed);
  rod_.emplace(std::move(lengths), options_.looped, fixed_, options_.material);
}

std::vector<Vertex> Rod::chain(const SurfaceMesh& mesh) const {
  std::vector<Vertex> vertices(fixed_.size());
  for (Vertex v : mesh.vertices())
    if (const std::int32_t place = (*places_)[v]; place > 0 && static_cast<std::size_t>(place) <= vertices.size())
      vertices[static_cast<std::size_t>(place) - 1] = v;
  if (std::ranges::find(vertices, Vertex()) != vertices.end())
    throw base::InputError("the rod's vertices are not a chain: a place has none");
  return vertices;
}

std::vector<RodFilm> Rod::films(const EffectStep& step, const std::vector<Vertex>& vertices,
                                std::span<const Vec3> x) const {
  std::vector<RodFilm> films;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    for (Triangle t : step.mesh.triangles(vertices[i])) {
      if (!options_.reference && is_solid(t, step.solid)) continue;
      const auto& v = step.mesh.vertices(t);
      const auto k = static_cast<std::size_t>(std::ranges::find(v, vertices[i]) - v.begin());
      films.push_back({i, x[v[(k + 1) % 3].index()], x[v[(k + 2) % 3].index()]});
    }
  return films;
}

void Rod::advance(const EffectStep& step) {
  targets_.assign(step.mesh.positions().begin(), step.mesh.positions().end());
  before_.assign(targets_.size(), Vec3::Zero());
  const std::vector<Vertex> vertices = chain(step.mesh);
  RodChain::Points x, v;
  for (Vertex vertex : vertices) {
    x.push_back(step.mesh.position(vertex));
    v.push_back((*velocities_)[vertex]);
    before_[vertex.index()] = v.back();
  }
  // The reference program's rod makes a step on each of the two ticks that are one step here.
  for (int tick = 0; tick < (options_.reference ? 2 : 1); ++tick) {
    const std::vector<RodFilm> around = films(step, vertices, targets_);
    rod_->advance(step.dt, options_.reference ? RodScheme::reference : RodScheme::implicit, options_.pull, around, x,
                  v);
    for (std::size_t i = 0; i < vertices.size(); ++i) targets_[vertices[i].index()] = x[i];
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) (*velocities_)[vertices[i]] = v[i];
}

std::vector<std::uint8_t> Rod::wired() const {
  std::vector<std::uint8_t> wired;
  for (std::int32_t place : places_->slots()) wired.push_back(place > 0 ? 1 : 0);
  return wired;
}

AirChange Rod::correct_circulation(const EffectStep& step, CirculationField& circulation, const SheetAir& air) {
  advance(step);
  if (!air.velocity) return {};
  return air_.solve(step, wired(), targets_, circulation, air);
}

void Rod::add_velocity(const Stage& stage, std::span<Vec3> velocity) {
  air_.add_velocity(stage, velocity);
}

void Rod::tell_motion(const EffectStep& step, HeldMotion& motion) const {
  motion.resize(step.mesh.vertex_slots());
  const std::vector<std::uint8_t> air = air_.takes_air(step, wired());
  // Of the reference's rod two steps make one here.
  const double ticks = options_.reference ? 2 : 1;
  for (Vertex v : step.mesh.vertices()) {
    if ((*places_)[v] == 0 || !(step.dt > 0)) continue;
    motion.driven[v.index()] = 1;
    motion.before[v.index()] = ticks * before_[v.index()];
    motion.takes_air[v.index()] = air[v.index()];
    motion.now[v.index()] = (targets_[v.index()] - step.mesh.position(v)) / step.dt;
  }
}

void Rod::prescribe(const Stage& stage, std::span<Vec3> positions) {
  const double part = stage.step.dt > 0 ? (stage.time - stage.step.time) / stage.step.dt : 0;
  const auto start = stage.step.mesh.positions();
  for (Vertex v : stage.step.mesh.vertices())
    if ((*places_)[v] != 0) positions[v.index()] = start[v.index()] + part * (targets_[v.index()] - start[v.index()]);
}

nlohmann::json Rod::state() const {
  // Of one that is on its way and has to be put back: something, so that it cannot be left out.
  if (!rod_) return nlohmann::json::object();
  return {{"lengths", rod_->lengths()}, {"fixed", std::vector<int>(fixed_.begin(), fixed_.end())}};
}

void Rod::restore(const nlohmann::json& json_state) {
  const base::CheckedJson state(json_state, "the state of constraint 'rod'");
  std::vector<char> fixed;
  for (const base::CheckedJson& each : state.at("fixed").entries(fixed_.size()))
    fixed.push_back(static_cast<char>(each.whole_number(0, 1)));
  std::vector<double> lengths;
  for (const base::CheckedJson& each : state.at("lengths").entries(options_.looped ? fixed.size() : fixed.size() - 1))
    lengths.push_back(each.positive_number());
  make_chain(std::move(lengths), std::move(fixed));
}

}  // namespace foamsim
