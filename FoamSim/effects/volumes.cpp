#include "FoamSim/effects/volumes.h"

#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "FoamSim/sheet/bubble_volumes.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr int newton_steps = 2;

}  // namespace

void Volumes::attach(SurfaceMesh& mesh) {
  wanted_ = closed_bubbles(mesh);
}

void Volumes::velocity_added(const Stage& stage, std::span<const Vec3> added) {
  if (stage.time != stage.step.time) return;
  for (Triangle t : stage.step.mesh.triangles()) {
    Vec3 mean = Vec3::Zero();
    for (Vertex v : stage.step.mesh.vertices(t)) mean += added[v.index()] / 3;
    const double change = stage.step.dt * mean.dot(area_vector_at(stage.step.mesh, t, stage.positions));
    if (const auto it = wanted_.find(stage.step.mesh.labels(t).p); it != wanted_.end()) it->second += change;
    if (const auto it = wanted_.find(stage.step.mesh.labels(t).q); it != wanted_.end()) it->second -= change;
  }
}

void Volumes::volume_let_in(Region region, double volume) {
  if (const auto it = wanted_.find(region); it != wanted_.end()) it->second += volume;
}

void Volumes::follow(const SurfaceMesh& mesh) {
  const std::map<Region, double> now = closed_bubbles(mesh);
  for (const auto& [gone, had] : wanted_) {
    if (now.contains(gone)) continue;
    for (const auto& [region, volume] : now)
      if (const auto it = wanted_.find(region); it != wanted_.end() && volume - it->second > 0.5 * had)
        it->second += had;
  }
  std::erase_if(wanted_, [&now](const auto& entry) { return !now.contains(entry.first); });
  wanted_.insert(now.begin(), now.end());
}

void Volumes::move_vertices(const Stage& stage, std::span<Vec3> positions) {
  // Stages of an integrator are on the way; what counts is where the step ends.
  if (stage.time < stage.step.time + 0.999 * stage.step.dt) return;
  follow(stage.step.mesh);
  correct(stage.step, positions);
}

bool Volumes::settle(const EffectStep& step, std::span<Vec3> positions) {
  constexpr double negligible = 1e-6;
  follow(step.mesh);
  const Eigen::VectorXd missing = BubbleVolumes(step.mesh, wanted_).missing(positions);
  Eigen::Index row = 0;
  bool all_right = true;
  for (const auto& [region, volume] : wanted_)
    all_right = std::abs(missing[row++]) <= negligible * std::abs(volume) && all_right;
  if (!all_right) correct(step, positions);
  return !all_right;
}

void Volumes::correct(const EffectStep& at, std::span<Vec3> positions) const {
  BubbleVolumes bubbles(at.mesh, wanted_);
  for (int step = 0; step < newton_steps && bubbles.rows() > 0; ++step) {
    if (!bubbles.update(positions, [&at](Vertex v) { return !at.is_held(v); })) return;
    const Eigen::VectorXd factors = bubbles.solve(bubbles.missing(positions));
    if (factors.size() == 0) return;
    bubbles.add(factors, true, positions);
  }
}

nlohmann::json Volumes::state() const {
  nlohmann::json state = nlohmann::json::array();
  for (const auto& [region, volume] : wanted_) state.push_back({region.index(), volume});
  return state;
}

void Volumes::restore(const nlohmann::json& state) {
  std::map<Region, double> wanted;
  for (const base::CheckedJson& entry : base::CheckedJson(state, "the state of effect 'volumes'").entries()) {
    const auto parts = entry.entries(2);
    wanted[Region(parts[0].index())] = parts[1].finite_number();
  }
  wanted_ = std::move(wanted);
}

}  // namespace foamsim
