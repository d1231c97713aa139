// A bubble of a cluster bursts: what becomes of the others, of the energy, and of the state.
#include "FoamSim/effects/burst.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/conservative/burst_potential.h"
#include "FoamSim/dynamics/conservative.h"
#include "FoamSim/dynamics/simulation_state.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/effects/volumes.h"
#include "FoamSim/scenes/foam_start.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_burst.h"
#include "tests/FoamSim/conservative/film_system.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/film_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

constexpr double dt = 0.005;

SimulationOptions remeshed() {
  SimulationOptions options{.dt = dt};
  options.tracker.remeshing = true;
  options.tracker.topology.enabled = true;
  return options;
}

Simulation cluster(bool conservative, const BurstSchedule& schedule) {
  SimulationParts parts;
  if (conservative) {
    parts.dynamics = std::make_unique<Conservative>(ConservativeOptions{});
    parts.effects.push_back(std::make_unique<SurfaceTension>(1, nullptr));
    parts.effects.push_back(std::make_unique<Volumes>());
  } else {
    parts = test::parts(test::tension());
    parts.effects.push_back(std::make_unique<Diffusion>(10));
  }
  parts.effects.push_back(std::make_unique<Burst>(schedule));
  SimulationOptions options = remeshed();
  options.tracker.remesh.max_volume_change = 0.002;
  return {grown_foam(4, 1), options, std::move(parts)};
}

TEST(ABurst, LeavesTheOtherBubblesTheirVolumesAndCountsItsWork) {
  Simulation films = cluster(true, {.times = {10 * dt}, .regions = {Region(2)}});
  const auto start = lostopos::closed_region_volumes(films.mesh());
  StepReport report;
  for (int i = 0; i < 10; ++i) report = films.step();
  const double before = report.kinetic_energy + report.potential_energy, kinetic_before = report.kinetic_energy;
  double work = 0, lost = 0;
  for (int i = 0; i < 20; ++i) {
    report = films.step();
    if (i == 0) {
      ASSERT_FALSE(report.topology.events.empty());
      EXPECT_EQ(report.topology.events[0].kind, lostopos::TopologyOperation::burst);
      EXPECT_EQ(report.topology.events[0].regions, std::vector<Region>{Region(2)});
      EXPECT_LT(report.effect_work, -0.1 * before) << "a film is gone";
    }
    work += report.effect_work;
    // What the tracker takes from the films and the air is lost.
    lost += std::min(0.0, report.tracker_surface_energy) + std::min(0.0, report.tracker_kinetic_energy);
    EXPECT_TRUE(lostopos::audit(films.mesh()).clean()) << lostopos::audit(films.mesh()).text();
  }
  EXPECT_EQ(lostopos::regions(films.mesh()), (std::vector<Region>{air, Region(1), Region(3), Region(4)}));
  EXPECT_LT(lostopos::largest_volume_drift(lostopos::closed_region_volumes(films.mesh()), start), 1e-3);
  EXPECT_NEAR(report.kinetic_energy + report.potential_energy, before + work + lost, 0.005 * before);
  EXPECT_GT(lost, -0.02 * before);
  EXPECT_GT(report.kinetic_energy, kinetic_before) << "what was pressed flat becomes round";
}

TEST(ABurst, IsAStepLikeAnyOther) {
  for (bool conservative : {false, true}) {
    const BurstSchedule schedule{.start = 2 * dt, .interval = 3 * dt, .seed = 5};
    Simulation one = cluster(conservative, schedule), other = cluster(conservative, schedule);
    for (int i = 0; i < 4; ++i) one.step();
    const auto bytes = nlohmann::json::to_cbor(to_json(one.state()));
    other.restore(simulation_state_from_json(nlohmann::json::from_cbor(bytes)));
    for (int i = 0; i < 3; ++i) {
      one.step();
      other.step();
    }
    EXPECT_EQ(lostopos::regions(one.mesh()).size(), 3U) << "two of four have burst";
    EXPECT_EQ(nlohmann::json::to_cbor(to_json(other.state())), nlohmann::json::to_cbor(to_json(one.state())));
    EXPECT_TRUE(lostopos::audit(one.mesh()).clean()) << lostopos::audit(one.mesh()).text();
  }
}

TEST(ABurst, OfTheLastFilmIsRefusedAndLeavesEverythingAsItWas) {
  Simulation films = cluster(true, {.times = {0, 0, 0, 0}, .regions = {Region(1), Region(2), Region(3), Region(4)}});
  for (int i = 0; i < 3; ++i) films.step();
  const auto before = nlohmann::json::to_cbor(to_json(films.state()));
  EXPECT_THROW(films.step(), base::Error);
  EXPECT_EQ(nlohmann::json::to_cbor(to_json(films.state())), before);
}

// φ before and after a burst, on a fixed mesh.
struct Opened {
  explicit Opened(SurfaceMesh films) : mesh(std::move(films)), before(mesh) {}
  // φ of the films that are left, by their entries.
  std::vector<double> burst(std::vector<double> phi, Region region) {
    const BurstPotential transfer(before.films, before.shape, phi, region);
    lostopos::burst_region(mesh, region);
    after.emplace(mesh);
    std::vector<double> left(after->films.entries());
    for (std::size_t v = 0; v < mesh.vertex_slots(); ++v)
      for (std::size_t e = after->films.first_entry[v]; e < after->films.first_entry[v + 1]; ++e)
        for (std::size_t old = before.films.first_entry[v]; old < before.films.first_entry[v + 1]; ++old)
          if (before.films.regions[old] == after->films.regions[e]) left[e] = phi[old];
    transfer.finish(after->films, after->shape, left);
    return left;
  }
  SurfaceMesh mesh;
  test::FilmSystem before;
  std::optional<test::FilmSystem> after;
};

TEST(BurstPotentialTest, LeavesAirAtRestAtRest) {
  Opened films(lostopos::test::analytic_double_bubble(1, 24));
  std::vector<double> phi(films.before.films.entries());
  // What pressure at rest has made: a constant a region.
  for (std::size_t e = 0; e < phi.size(); ++e) phi[e] = 3.0 * films.before.films.regions[e].index() + 1;
  const std::vector<double> left = films.burst(phi, Region(2));
  const FilmMotion motion = films.after->motion(left, 0.1);
  EXPECT_NEAR(motion.kinetic_energy(), 0, 1e-20);
}

// ∫ 2Γ n dA and ∫ Γ dA of the films towards region 1, region 2 and the air taken for one where `joined`.
TEST(BurstPotentialTest, KeepsTheImpulseAndTheIntegralsOfTheFilmsThatAreLeft) {
  Opened films(lostopos::test::analytic_double_bubble(1, 24));
  const std::vector<double> phi = films.before.random_phi();
  // The level by which region 2 is shifted: the mean of the difference over the border, by area.
  const auto& f = films.before.films;
  const auto entry = [&f](std::size_t v, unsigned r) {
    for (std::size_t e = f.first_entry[v]; e < f.first_entry[v + 1]; ++e)
      if (f.regions[e] == Region(r)) return static_cast<long>(e);
    return -1L;
  };
  double sum = 0, weight = 0;
  for (std::size_t v = 0; v < f.vertex_slots(); ++v) {
    if (entry(v, 0) < 0 || entry(v, 1) < 0 || entry(v, 2) < 0) continue;
    double area = 0;
    for (std::uint32_t corner : f.around(v)) {
      const auto t = corner / 3;
      if (f.regions[f.front[t][0]] == Region(1) || f.regions[f.back[t][0]] == Region(1))
        area += films.before.shape.area[t] / 3;
    }
    sum += area * (phi[static_cast<std::size_t>(entry(v, 0))] - phi[static_cast<std::size_t>(entry(v, 2))]);
    weight += area;
  }
  ASSERT_GT(weight, 0);
  const double level = sum / weight;
  Vec3 impulse = Vec3::Zero();
  double integral = 0;
  for (std::size_t t = 0; t < f.corners.size(); ++t) {
    const bool front = f.regions[f.front[t][0]] == Region(1), back = f.regions[f.back[t][0]] == Region(1);
    if (!front && !back) continue;
    double mean = 0;
    for (std::size_t k = 0; k < 3; ++k) mean += (phi[f.front[t][k]] - phi[f.back[t][k]]) / 3;
    const Region other = f.regions[front ? f.back[t][0] : f.front[t][0]];
    if (other == Region(2)) mean += front ? -level : level;
    impulse += 2 * mean * films.before.shape.area_vector[t];
    integral += (front ? mean : -mean) * films.before.shape.area[t];
  }
  const std::vector<double> left = films.burst(phi, Region(2));
  const auto& g = films.after->films;
  Vec3 impulse_left = Vec3::Zero();
  double integral_left = 0;
  for (std::size_t t = 0; t < g.corners.size(); ++t) {
    double mean = 0;
    for (std::size_t k = 0; k < 3; ++k) mean += (left[g.front[t][k]] - left[g.back[t][k]]) / 3;
    impulse_left += 2 * mean * films.after->shape.area_vector[t];
    integral_left += (g.regions[g.front[t][0]] == Region(1) ? mean : -mean) * films.after->shape.area[t];
  }
  EXPECT_LT((impulse_left - impulse).norm(), 1e-10);
  EXPECT_NEAR(integral_left, integral, 1e-10);
}

}  // namespace
}  // namespace foamsim
