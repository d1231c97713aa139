// The conservative dynamics as a whole.

#include "FoamSim/dynamics/conservative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/effects/volumes.h"
#include "FoamSim/metrics/film_angles.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/velocity/tree/tree.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "tests/support/film_meshes.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

SimulationParts parts(const ConservativeOptions& options, bool volumes = false) {
  SimulationParts made{.dynamics = std::make_unique<Conservative>(options)};
  made.effects.push_back(std::make_unique<SurfaceTension>(1, nullptr));
  if (volumes) made.effects.push_back(std::make_unique<Volumes>());
  return made;
}

// Films that stay as they are meshed.
SimulationOptions fixed(double dt, double delta = 0) {
  SimulationOptions options{.dt = dt, .delta = delta};
  options.tracker.collisions = false;
  return options;
}

double energy(const StepReport& report) {
  return report.kinetic_energy + report.potential_energy;
}

ConservativeOptions as_derived() {
  return {.stepping = Stepping::rk4, .near_field = false, .tangential = Tangential::none, .correction = false};
}

struct Printed {
  int step;
  double kinetic, surface;
};

// What an independent implementation (NumPy, dense sums, RK4) gives for the same meshes, δ and dt.
void expect_as_printed(SurfaceMesh mesh, double delta, std::span<const Printed> printed) {
  Simulation simulation(std::move(mesh), fixed(0.004, delta), parts(as_derived()));
  std::vector<StepReport> reports;
  for (int i = 0; i <= printed.back().step; ++i) reports.push_back(simulation.step());
  for (const Printed& p : printed) {
    EXPECT_NEAR(reports[static_cast<std::size_t>(p.step)].kinetic_energy, p.kinetic, 1e-9) << p.step;
    EXPECT_NEAR(reports[static_cast<std::size_t>(p.step)].potential_energy, p.surface, 1e-9) << p.step;
  }
}

TEST(Conservative, MovesADoubleBubbleAsTheReferenceDoes) {
  constexpr Printed printed[] = {{1, 0.00045950148975120987, 91.91878440157096},
                                 {5, 0.011471267673433908, 91.90777263536333},
                                 {10, 0.045676281862936527, 91.873567621109487}};
  expect_as_printed(double_bubble(8), 0.2, printed);
}

TEST(Conservative, MovesACubeAsTheReferenceDoes) {
  constexpr Printed printed[] = {{1, 0.0012303511452027044, 31.998769648853958},
                                 {5, 0.03071109411694041, 31.969288905878624},
                                 {10, 0.12224799498662343, 31.877752005004155}};
  expect_as_printed(cube(1), 0.3, printed);
}

// Largest |K + E − start| over K's peak by time 0.32.
double energy_error(Stepping stepping, double dt) {
  ConservativeOptions options = as_derived();
  options.stepping = stepping;
  SurfaceMesh mesh = icosphere(1);
  perturb_with_mode(mesh, 2, 0.1);
  Simulation simulation(std::move(mesh), fixed(dt), parts(options));
  double first = 0, worst = 0;
  for (long i = 0; i * dt < 0.32; ++i) {
    const double now = energy(simulation.step());
    if (i == 0) first = now;
    worst = std::max(worst, std::abs(now - first));
  }
  return worst;
}

TEST(Conservative, KeepsEnergyToTheOrderOfItsStepping) {
  EXPECT_GT(std::log2(energy_error(Stepping::rk4, 0.01) / energy_error(Stepping::rk4, 0.005)), 3.5);
  EXPECT_NEAR(std::log2(energy_error(Stepping::midpoint, 0.02) / energy_error(Stepping::midpoint, 0.01)), 2, 0.4);
  EXPECT_GT(std::log2(energy_error(Stepping::kick_drift, 0.02) / energy_error(Stepping::kick_drift, 0.01)), 0.8);
}

// K and K + E of a double bubble that opens, step by step.
std::vector<std::pair<double, double>> energies(std::shared_ptr<const BiotSavart> sum) {
  const ConservativeOptions options{.correction = false};
  SimulationParts made{.dynamics = std::make_unique<Conservative>(options, std::move(sum))};
  made.effects.push_back(std::make_unique<SurfaceTension>(1, nullptr));
  Simulation simulation(double_bubble(48), fixed(0.003), std::move(made));
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i < 2; ++i) {
    const StepReport report = simulation.step();
    all.emplace_back(report.kinetic_energy, energy(report));
  }
  return all;
}

TEST(Conservative, KeepsEnergyByTreeAsWellAsDirectly) {
  const auto direct = energies(std::make_shared<DirectBiotSavart>());
  const double most = direct.back().first;
  ASSERT_GT(most, 1e-4);
  for (double tolerance : {1e-4, 1e-6}) {
    const auto by_tree = energies(std::make_shared<TreeBiotSavart>(TreeOptions{.tolerance = tolerance}));
    double kinetic = 0, total = 0;
    for (std::size_t i = 0; i < direct.size(); ++i) {
      kinetic = std::max(kinetic, std::abs(by_tree[i].first - direct[i].first));
      total = std::max(total, std::abs(by_tree[i].second - direct[i].second));
    }
    EXPECT_LT(kinetic, tolerance * most);
    EXPECT_LT(total, tolerance * most);
    EXPECT_GT(kinetic, 1e-12 * most) << "it was direct after all";
  }
}

// Viscosity's linear system once made rounding a part in a million within ten steps.
TEST(Conservative, MovesTheSameAThousandRadiiAway) {
  ConservativeOptions options;
  options.viscosity = 0.1;
  const Vec3 offset(300, -860, 430);
  // Without noise, edges that are alike by symmetry would be told apart by rounding alone.
  SurfaceMesh near = double_bubble(12), far = double_bubble(12);
  for (lostopos::Vertex v : near.vertices()) {
    const double i = v.index();
    near.set_position(v, near.position(v) + 1e-3 * Vec3(std::sin(i), std::sin(2.3 * i), std::sin(3.7 * i)));
    far.set_position(v, near.position(v) + offset);
  }
  Simulation here(std::move(near), fixed(0.01), parts(options, true));
  Simulation there(std::move(far), fixed(0.01), parts(options, true));
  for (int i = 0; i < 15; ++i) {
    here.step();
    there.step();
  }
  for (lostopos::Vertex v : here.mesh().vertices())
    EXPECT_LT((here.mesh().position(v) + offset - there.mesh().position(v)).norm(), 1e-10) << v.index();
}

TEST(Conservative, KeepsVolumesToTheOrderOfItsSteppingAndToRoundingWithVolumes) {
  for (bool volumes : {false, true}) {
    Simulation simulation(double_bubble(12), fixed(0.01), parts({}, volumes));
    const auto start = lostopos::closed_region_volumes(simulation.mesh());
    for (int i = 0; i < 30; ++i) simulation.step();
    const double drift = lostopos::largest_volume_drift(lostopos::closed_region_volumes(simulation.mesh()), start);
    EXPECT_LT(drift, volumes ? 1e-12 : 1e-3);
  }
}

// No damping: what it wins by remeshing it gives back.
TEST(Conservative, DoesNotWinEnergyOnARemeshedDoubleBubble) {
  Scene scene = built_in_scene("doublebubble");
  scene.options.set("n", 16L, "test");
  choose_method(scene.options, conservative_method, "test");
  Simulation simulation = make_simulation(scene);
  const auto start = lostopos::closed_region_volumes(simulation.mesh());
  double least = 1e300, first = 0, rise = 0, drift = 0, impulse = 0;
  for (int i = 0; i < 200; ++i) {
    const StepReport report = simulation.step();
    if (i == 0) first = energy(report);
    least = std::min(least, energy(report));
    rise = std::max(rise, energy(report) - least);
    drift = std::max(drift, lostopos::largest_volume_drift(lostopos::closed_region_volumes(simulation.mesh()), start));
    impulse = std::max(impulse, report.impulse.norm() / std::max(1e-12, report.impulse_scale));
    ASSERT_TRUE(lostopos::audit(simulation.mesh()).clean()) << i;
  }
  EXPECT_LT(rise, 1e-3 * first);
  EXPECT_LT(drift, 1e-5);
  EXPECT_LT(impulse, 0.01);
}

// Nothing collides here, so that all that the tracker does to the air is remeshing; the whole is known to second order
// in dt, one step later.
TEST(Conservative, TellsWhatRemeshingPutsIntoTheAirAndStaysAsItIs) {
  const auto run = [](bool measured) {
    SimulationOptions options{.dt = 0.01, .resolution = 0.25, .air_by_stage = measured};
    options.tracker.remeshing = true;
    auto simulation = std::make_unique<Simulation>(double_bubble(12), options, parts({}));
    std::vector<StepReport> reports(40);
    for (StepReport& report : reports) report = simulation->step();
    return std::pair(std::move(simulation), std::move(reports));
  };
  const auto [simulation, reports] = run(true);
  double most = 0, amiss = 0;
  for (std::size_t i = 0; i + 1 < reports.size(); ++i) {
    ASSERT_EQ(reports[i].move.collisions, 0U);
    EXPECT_EQ(reports[i].topology_air_energy, 0.0);
    const double remeshing = reports[i].remesh_air_energy.value();
    most = std::max(most, std::abs(remeshing));
    amiss = std::max(amiss, std::abs(reports[i + 1].tracker_kinetic_energy - remeshing));
  }
  EXPECT_GT(most, 0.001) << "hardly remeshed: too weak a test";
  EXPECT_LT(amiss, 0.25 * most);
  const auto [same, silent] = run(false);
  EXPECT_FALSE(silent.back().remesh_air_energy);
  EXPECT_TRUE(lostopos::test::same_bits(same->state().tracker, simulation->state().tracker));
}

// A film that vanishes is drawn out to slivers, whose short edges would ask for steps in many parts.
TEST(Conservative, MakesStepsInFewPartsWhileFilmsVanish) {
  constexpr long steps = 50;
  const auto parts_with = [](std::initializer_list<const char*> assignments) {
    Scene scene = built_in_scene("foam");
    for (const char* each : {"bubbles=15", "resolution=0.3", "seed=4", "relax=3", "dynamics=conservative", "dt=0.015"})
      scene.options.set_assignment(each, "test");
    for (const char* each : assignments) scene.options.set_assignment(each, "test");
    Simulation simulation = make_simulation(scene);
    long parts = 0, merges = 0;
    double first = 0, highest = 0;
    for (long i = 0; i < steps; ++i) {
      const StepReport report = simulation.step();
      parts += report.substeps;
      merges += static_cast<long>(report.topology[lostopos::TopologyOperation::edge_merge].done);
      if (i == 0) first = energy(report);
      highest = std::max(highest, energy(report));
      EXPECT_TRUE(lostopos::audit(simulation.mesh()).clean()) << i;
    }
    EXPECT_GT(merges, 0);
    EXPECT_LT(highest, (1 + 1e-3) * first);
    return parts;
  };
  EXPECT_LE(parts_with({}), steps + 3);
  EXPECT_GT(parts_with({"topology.pull_apart=0.1", "topology.merge_edge=0.05"}), steps + 6);
}

TEST(Conservative, GoesOnFromASavedStateToTheBit) {
  const auto make = [] { return Simulation(double_bubble(8), fixed(0.01), parts({}, true)); };
  Simulation whole = make(), first = make(), second = make();
  for (int i = 0; i < 10; ++i) whole.step();
  for (int i = 0; i < 5; ++i) first.step();
  const auto text = nlohmann::json::to_cbor(to_json(first.state()));
  second.restore(simulation_state_from_json(nlohmann::json::from_cbor(text)));
  for (int i = 0; i < 5; ++i) second.step();
  EXPECT_TRUE(lostopos::test::same_bits(whole.state().tracker, second.state().tracker));
}

TEST(Conservative, RefusesWhatOnlyTheVortexSheetHas) {
  const auto refused = [](const char* key, const base::OptionValue& value, const char* why) {
    Scene scene = built_in_scene("doublebubble");
    scene.options.set("dynamics", std::string("conservative"), "test");
    scene.options.set(key, value, "test");
    try {
      validate(scene);
      ADD_FAILURE() << key;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused("area", std::string("naive"), "exact forces");
  refused("phi", 0.5, "exact forces");
  refused("integrator", std::string("rk4"), "stepping");
  refused("effects", std::vector<std::string>{"surface_tension", "diffusion"}, "viscosity");
}

}  // namespace
}  // namespace foamsim
