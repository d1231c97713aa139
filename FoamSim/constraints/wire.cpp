#include "FoamSim/constraints/wire.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "Base/options/option_value.h"
#include "FoamSim/constraints/wire_groups.h"
#include "FoamSim/constraints/wire_transfer.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using Kind = WireMotion::Kind;

namespace {

// In resolutions: the films at a wire that goes farther in a step cannot follow.
constexpr double farthest_in_a_step = 1;

void require_slow(const WireSpec& wire, double resolution, double dt) {
  const double speed = wire.motion.kind == Kind::pull ? std::abs(wire.motion.speed) : wire.motion.velocity.norm();
  const double longest = farthest_in_a_step * resolution;
  if (speed * dt <= longest) return;
  throw base::InputError("the wire '" + wire.text() + "' goes " + base::to_text(speed * dt) +
                         " in a step, farther than the resolution of " + base::to_text(resolution) +
                         ", and would be dragged through the films; give dt below " + base::to_text(longest / speed) +
                         " or a lower speed");
}

}  // namespace

Wire::Wire(std::vector<WireSpec> wires, const WireAirOptions& air, double resolution, double dt)
    : wires_(std::move(wires)), axes_(wires_.size(), Vec3::Zero()), air_(air) {
  for (const WireSpec& wire : wires_) require_slow(wire, resolution, dt);
}

void Wire::attach(lostopos::SurfaceTracker& tracker) {
  const SurfaceMesh& mesh = tracker.mesh();
  paths_.emplace(tracker.mesh().add_vertex_attribute<Path>("wire", std::make_unique<WireTransfer>(), none));
  // What is on its way already knows where it belongs.
  if (std::ranges::any_of(paths_->slots(), [](Path path) { return path != none; })) return require_known_paths(mesh);
  const std::vector<lostopos::Hold> held(tracker.held().slots().begin(), tracker.held().slots().end());
  for (std::size_t i = 0; i < wires_.size(); ++i) hold(mesh, i, wires_[i].selection.of(mesh, held));
  for (Vertex v : mesh.vertices())
    if (lostopos::is_held(held[v.index()]) && (*paths_)[v] == none) (*paths_)[v] = still;
  bool any = false;
  for (Vertex v : mesh.vertices()) {
    if ((*paths_)[v] == none) continue;
    tracker.held()[v] = lostopos::Hold::all;
    any = true;
  }
  if (!any)
    throw base::InputError(
        "constraint 'wire' has nothing to hold: the start mesh marks no vertices as held, and no wire names any; give "
        "--set wires='SELECTION: MOTION'");
}

void Wire::require_known_paths(const SurfaceMesh& mesh) const {
  for (Vertex v : mesh.vertices())
    if (const Path its = (*paths_)[v]; its < none || its >= path(wires_.size(), false))
      throw base::InputError("vertex " + std::to_string(v.index()) + " is on wire path " + std::to_string(its) +
                             ", and there are " + std::to_string(wires_.size()) + " wires");
}

void Wire::hold(const SurfaceMesh& mesh, std::size_t wire, const std::vector<Vertex>& vertices) {
  const bool pulls = wires_[wire].motion.kind == Kind::pull;
  const WireGroups groups =
      pulls ? part_groups(mesh, wires_[wire], vertices) : WireGroups{std::vector<char>(vertices.size(), 0), {}};
  if (pulls) axes_[wire] = groups.axis;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Path& path = (*paths_)[vertices[i]];
    if (path != none)
      throw base::InputError("vertex " + std::to_string(vertices[i].index()) + " belongs to two wires, '" +
                             wires_[static_cast<std::size_t>(path - 2) / 2].text() + "' and '" + wires_[wire].text() +
                             "'; it can follow one");
    path = Wire::path(wire, groups.second[i] != 0);
  }
}

Vec3 Wire::displacement(Path path, double start, double end) const {
  if (path < 2) return Vec3::Zero();
  const auto wire = static_cast<std::size_t>(path - 2) / 2;
  const WireMotion& motion = wires_[wire].motion;
  if (motion.kind == Kind::still) return Vec3::Zero();
  if (motion.kind == Kind::move) return motion.displacement(motion.velocity, start, end);
  const double speed = path % 2 == 0 ? -motion.speed : motion.speed;
  return motion.displacement(speed * axes_[wire], start, end);
}

std::vector<std::uint8_t> Wire::wired() const {
  std::vector<std::uint8_t> wired;
  for (Path path : paths_->slots()) wired.push_back(path != none ? 1 : 0);
  return wired;
}

AirChange Wire::correct_circulation(const EffectStep& step, CirculationField& circulation, const SheetAir& air) {
  if (!air.velocity) return {};
  std::vector<Vec3> targets(step.mesh.positions().begin(), step.mesh.positions().end());
  prescribe({step, step.time + step.dt, targets}, targets);
  return air_.solve(step, wired(), targets, circulation, air);
}

void Wire::add_velocity(const Stage& stage, std::span<Vec3> velocity) {
  air_.add_velocity(stage, velocity);
}

void Wire::tell_motion(const EffectStep& step, HeldMotion& motion) const {
  motion.resize(step.mesh.vertex_slots());
  const std::vector<std::uint8_t> air = air_.takes_air(step, wired());
  for (Vertex v : step.mesh.vertices()) {
    const Path path = (*paths_)[v];
    if (path == none || !(step.dt > 0)) continue;
    motion.driven[v.index()] = 1;
    motion.now[v.index()] = displacement(path, step.time, step.time + step.dt) / step.dt;
    motion.takes_air[v.index()] = air[v.index()];
    // Before the first step all stand still.
    if (step.time > 0) motion.before[v.index()] = displacement(path, step.time - step.dt, step.time) / step.dt;
  }
}

void Wire::prescribe(const Stage& stage, std::span<Vec3> positions) {
  const auto start = stage.step.mesh.positions();
  for (Vertex v : stage.step.mesh.vertices())
    if (const Path path = (*paths_)[v]; path != none)
      positions[v.index()] = start[v.index()] + displacement(path, stage.step.time, stage.time);
}

bool Wire::pulls() const {
  return std::ranges::any_of(wires_, [](const WireSpec& wire) { return wire.motion.kind == Kind::pull; });
}

nlohmann::json Wire::state() const {
  if (!pulls()) return nullptr;
  nlohmann::json axes = nlohmann::json::array();
  for (const Vec3& axis : axes_) axes.push_back({axis.x(), axis.y(), axis.z()});
  return axes;
}

void Wire::restore(const nlohmann::json& state) {
  if (!pulls() && state.is_null()) return;
  const auto axes = base::CheckedJson(state, "the state of constraint 'wire'").entries(axes_.size());
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const std::vector<double> axis = axes[i].finite_numbers(3);
    axes_[i] = Vec3(axis[0], axis[1], axis[2]);
  }
}

}  // namespace foamsim
