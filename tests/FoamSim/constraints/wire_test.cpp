// Wires: vertices go where they are sent, to the bit, and what cannot be held is refused.
#include "FoamSim/constraints/wire.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "tests/FoamSim/constraints/made_wire.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

// Two rings with a film between them.
Simulation tube(std::unique_ptr<Wire> constraint, bool remesh = true) {
  SimulationOptions options{.dt = 0.01, .resolution = remesh ? 0.12 : 0.0, .tracker = {}};
  options.tracker.remeshing = remesh;
  options.tracker.remesh.collapse_to_held = false;
  options.tracker.topology.enabled = remesh;
  std::vector<std::unique_ptr<Effect>> effects;
  effects.push_back(test::tension());
  effects.push_back(std::make_unique<Diffusion>(4));
  SimulationParts parts = test::parts(std::move(effects));
  parts.constraints.push_back(std::move(constraint));
  return {lostopos::test::open_cylinder(0.5, 16, 4, 0.12), options, std::move(parts)};
}

std::vector<std::uint8_t> bits(const Simulation& simulation) {
  return nlohmann::json::to_cbor(to_json(simulation.state()));
}

TEST(Wire, GoesWhereItIsSentUntilItsTime) {
  Simulation simulation = tube(
      made_wire({"free-edges and x < 0.1: move -0.5 0 0.25 from 0.015 until 0.055", "free-edges and x > 0.1: still"}));
  std::vector<Vec3> start;
  for (Vertex v : simulation.mesh().vertices())
    if (lostopos::is_held(simulation.held()[v.index()])) start.push_back(simulation.mesh().position(v));
  ASSERT_EQ(start.size(), 32U);
  for (int i = 0; i < 8; ++i) simulation.step();
  EXPECT_NE(simulation.mesh().vertex_count(), 80U) << "not remeshed: too weak a test";
  std::vector<Vec3> end;
  for (Vertex v : simulation.mesh().vertices())
    if (lostopos::is_held(simulation.held()[v.index()])) end.push_back(simulation.mesh().position(v));
  EXPECT_EQ(end.size(), start.size());
  for (const Vec3& x : start) {
    const Vec3 expected = x.x() < 0.1 ? Vec3(x + 0.04 * Vec3(-0.5, 0, 0.25)) : x;
    EXPECT_TRUE(std::ranges::any_of(end, [&](const Vec3& y) { return (y - expected).norm() < 1e-14; }));
  }
}

TEST(Wire, PullsTwoRingsApart) {
  Simulation simulation = tube(made_wire({"free-edges: pull 0.4"}), false);
  for (int i = 0; i < 5; ++i) simulation.step();
  for (Vertex v : simulation.mesh().vertices()) {
    if (!lostopos::is_held(simulation.held()[v.index()])) continue;
    const double x = simulation.mesh().position(v).x();
    EXPECT_NEAR(std::abs(x - 0.24), 0.24 + 0.02, 1e-14);
  }
}

TEST(Wire, HasTheSameBitsForAnyNumberOfThreadsAndResumed) {
  const auto run = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Simulation simulation = tube(made_wire({"free-edges: pull 0.4"}, {.open_boundary = true, .interior_weight = 0.02}));
    for (int i = 0; i < 12; ++i) simulation.step();
    return bits(simulation);
  };
  const auto one = run(1);
  EXPECT_EQ(run(2), one);
  EXPECT_EQ(run(5), one);

  Simulation first = tube(made_wire({"free-edges: pull 0.4"}, {.open_boundary = true, .interior_weight = 0.02}));
  for (int i = 0; i < 6; ++i) first.step();
  const SimulationState state = simulation_state_from_json(nlohmann::json::from_cbor(bits(first)));
  SimulationParts parts = test::parts([] {
    std::vector<std::unique_ptr<Effect>> effects;
    effects.push_back(test::tension());
    effects.push_back(std::make_unique<Diffusion>(4));
    return effects;
  }());
  parts.constraints.push_back(made_wire({"free-edges: pull 0.4"}, {.open_boundary = true, .interior_weight = 0.02}));
  SimulationOptions options = first.options();
  options.resolution = first.resolution();
  Simulation second(SurfaceMesh::from_state(state.tracker), options, std::move(parts));
  second.restore(state);
  for (int i = 0; i < 6; ++i) second.step();
  EXPECT_EQ(bits(second), one);
}

TEST(Wire, RefusesASavedStateWithoutTheAxesThatItPullsAlong) {
  Simulation simulation = tube(made_wire({"free-edges: pull 0.4"}), false);
  simulation.step();
  nlohmann::json saved = nlohmann::json::from_cbor(bits(simulation));
  ASSERT_EQ(saved["models"]["constraints"].erase("wire"), 1u);
  EXPECT_THROW(simulation.restore(simulation_state_from_json(saved)), base::InputError);
}

TEST(Wire, LeavesEverythingAsItWasWhenAStepFails) {
  class Fails final : public Constraint {
   public:
    std::string_view name() const override { return "fails"; }
    void attach(lostopos::SurfaceTracker&) override {}
    void prescribe(const Stage& stage, std::span<Vec3> positions) override {
      if (stage.step.time > 0.025 && !behaves) positions[3].x() = std::nan("");
    }
    bool behaves = false;
  };
  const auto made = [](Fails*& fails) {
    std::vector<std::unique_ptr<Effect>> effects;
    effects.push_back(test::tension());
    SimulationParts parts = test::parts(std::move(effects));
    parts.constraints.push_back(made_wire({"free-edges: pull 0.4"}, {.open_boundary = true, .interior_weight = 0.02}));
    auto last = std::make_unique<Fails>();
    fails = last.get();
    parts.constraints.push_back(std::move(last));
    return Simulation(lostopos::test::open_cylinder(0.5, 16, 4, 0.12), {}, std::move(parts));
  };
  Fails *fails = nullptr, *never = nullptr;
  Simulation failing = made(fails), good = made(never);
  never->behaves = true;
  for (int i = 0; i < 3; ++i) failing.step();
  const auto before = bits(failing);
  EXPECT_ANY_THROW(failing.step());
  EXPECT_EQ(bits(failing), before);
  fails->behaves = true;
  for (int i = 0; i < 3; ++i) failing.step();
  for (int i = 0; i < 6; ++i) good.step();
  EXPECT_EQ(bits(failing), bits(good));
}

std::string refusal(const std::vector<std::string>& texts, double resolution = 0.2, double step = 0.01) {
  try {
    lostopos::SurfaceTracker tracker(lostopos::test::open_cylinder(0.5, 16, 4, 0.12), {.resolution = 0.2});
    std::vector<WireSpec> specs(texts.begin(), texts.end());
    Wire(std::move(specs), {.interior_weight = 0.02}, resolution, step).attach(tracker);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Wire, RefusesWhatItCannotHold) {
  EXPECT_EQ(refusal({"free-edges: still"}), "");
  EXPECT_EQ(refusal({"free-edges: still", "x < 0.01: move 1 0 0"}),
            "vertex 0 belongs to two wires, 'free-edges: still' and 'x < 0.01: move 1 0 0'; it can follow one");
  EXPECT_EQ(refusal({}),
            "constraint 'wire' has nothing to hold: the start mesh marks no vertices as held, and no wire names any; "
            "give --set wires='SELECTION: MOTION'");
  EXPECT_NE(refusal({"held: still"}).find("matches no vertex"), std::string::npos);
  EXPECT_NE(refusal({"x < 0.01: pull 1 along x"}).find("no two groups"), std::string::npos);
  EXPECT_NE(refusal({"free-edges: move 30 0 0"}).find("goes 0.3 in a step, farther than the resolution of 0.2"),
            std::string::npos);
}

}  // namespace
}  // namespace foamsim
