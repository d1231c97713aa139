// What effects do to the surface before a step, and what that puts into films and air.

#include <algorithm>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"
#include "FoamSim/dynamics/simulation.h"
#include "LosTopos/mesh/region_burst.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

bool is_all_of_surface(const SurfaceMesh& mesh, Region region) {
  return std::ranges::all_of(mesh.triangles(), [&](lostopos::Triangle t) {
    return mesh.labels(t).has(region) && mesh.labels(t).has(lostopos::air);
  });
}

}  // namespace

void Simulation::change_surface(StepReport& report) {
  for (const auto& effect : parts_.effects) {
    std::vector<Region> regions;
    std::vector<Vec3> positions;
    {
      const base::TimedScope timed(report.times, effect->name());
      const EffectStep step = effect_step();
      regions = effect->bursts(step);
      if (regions.empty()) positions = effect->displaced(step);
    }
    for (Region region : regions) burst(region, report);
    if (!positions.empty()) displace(positions, report);
  }
}

void Simulation::burst(Region region, StepReport& report) {
  SurfaceMesh& mesh = tracker_->mesh();
  if (is_all_of_surface(mesh, region))
    throw base::Error("region " + std::to_string(region.index()) + " is to burst at t = " + std::to_string(time()) +
                      ", and no film would be left");
  const base::TimedScope timed(report.times, "burst");
  const AirState before = parts_.dynamics->air(effect_step(), *circulation_);
  const double films_before = potential_energy();
  parts_.dynamics->before_burst(effect_step(), *circulation_, region);
  for (const auto& effect : parts_.effects) effect->region_bursts(region);
  const Vec3 centre = lostopos::burst_region(mesh, region);
  report.topology.events.push_back({lostopos::TopologyOperation::burst, {region}, centre});
  geometry_.update(mesh, solid());
  circulation_->match(mesh);
  parts_.dynamics->after_burst(effect_step(), *circulation_);
  count_work(before, films_before, report);
}

void Simulation::displace(std::span<const Vec3> positions, StepReport& report) {
  const SurfaceMesh& mesh = tracker_->mesh();
  const AirState before = parts_.dynamics->air(effect_step(), *circulation_);
  const double films_before = potential_energy();
  const std::vector<Vec3> start(mesh.positions().begin(), mesh.positions().end());
  {
    const base::TimedScope timed(report.times, "move");
    tracker_->advance(positions);
  }
  // As velocities that take the vertices there in the step, and before they are there.
  std::vector<Vec3> added(start.size());
  for (std::size_t v = 0; v < start.size(); ++v) added[v] = (mesh.positions()[v] - start[v]) / options_.dt;
  const EffectStep step = effect_step();
  for (const auto& effect : parts_.effects) effect->velocity_added({step, step.time, start}, added);
  geometry_.update(mesh, solid());
  count_work(before, films_before, report);
}

void Simulation::count_work(const AirState& before, double films_before, StepReport& report) {
  const AirState after = parts_.dynamics->air(effect_step(), *circulation_);
  const double films = potential_energy() - films_before;
  report.effect_work += films + after.kinetic_energy - before.kinetic_energy;
  parts_.dynamics->surface_changed(before, after, films);
}

}  // namespace foamsim
