// A step that fails leaves everything as it was, and a state that was taken can be put back: all to the bit.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "Base/error.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/dynamics/simulation_state.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/effects/growth.h"
#include "FoamSim/scenes/approach.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/two_bubbles.h"
#include "LosTopos/error.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

// The stage of a step in which it is to fail.
enum class Where {
  attach_only,
  circulation,
  velocity,
  positions,
  not_finite,
  constraint_circulation,
  constraint_positions
};

// Counts its steps, keeps a field on the films, and fails where it is told to.
class Saboteur final : public Effect {
 public:
  Saboteur(Where where, long fails_at) : where_(where), fails_at_(fails_at) {}
  std::string_view name() const override { return "saboteur"; }
  void attach(SurfaceMesh& mesh) override {
    dye_.emplace(mesh.add_vertex_attribute<double>("dye", lostopos::carry::interpolate, 1.0));
  }
  void update_circulation(const EffectStep& step, CirculationField&) override {
    ++count_;
    for (lostopos::Vertex v : step.mesh.vertices()) (*dye_)[v] += 0.25 * static_cast<double>(v.index());
    fail_in(Where::circulation);
  }
  void add_velocity(const Stage&, std::span<Vec3>) override { fail_in(Where::velocity); }
  void move_vertices(const Stage&, std::span<Vec3> positions) override {
    fail_in(Where::positions);
    if (where_ == Where::not_finite && count_ > fails_at_) positions[3].x() = std::nan("");
  }
  nlohmann::json state() const override { return count_; }
  void restore(const nlohmann::json& state) override { count_ = state; }
  void behave() { fails_at_ = 1000; }
  long count() const { return count_; }

 private:
  void fail_in(Where stage) const {
    if (where_ == stage && count_ > fails_at_) throw std::runtime_error("sabotage");
  }
  Where where_;
  long fails_at_, count_ = 0;
  std::optional<lostopos::VertexAttribute<double>> dye_;
};

class SabotagedConstraint final : public Constraint {
 public:
  SabotagedConstraint(Where where, long fails_at) : where_(where), fails_at_(fails_at) {}
  std::string_view name() const override { return "sabotaged"; }
  void attach(lostopos::SurfaceTracker&) override {}
  AirChange correct_circulation(const EffectStep&, CirculationField&, const SheetAir&) override {
    ++count_;
    if (where_ == Where::constraint_circulation && count_ > fails_at_) throw std::runtime_error("sabotage");
    return {};
  }
  void prescribe(const Stage&, std::span<Vec3>) override {
    if (where_ == Where::constraint_positions && count_ > fails_at_) throw std::runtime_error("sabotage");
  }
  nlohmann::json state() const override { return count_; }
  void restore(const nlohmann::json& state) override { count_ = state; }
  void behave() { fails_at_ = 1000; }

 private:
  Where where_;
  long fails_at_, count_ = 0;
};

// Two bubbles that meet while it lasts, remeshed and with changes of topology.
struct Meeting {
  Saboteur* saboteur;
  SabotagedConstraint* constraint;
  Simulation simulation;
};

Meeting meeting(Where where, long fails_at, const char* integrator) {
  SimulationOptions options;
  options.tracker.remeshing = true;
  options.tracker.topology.enabled = true;
  auto saboteur = std::make_unique<Saboteur>(where, fails_at);
  auto constraint = std::make_unique<SabotagedConstraint>(where, fails_at);
  Saboteur* effect = saboteur.get();
  SabotagedConstraint* held = constraint.get();
  std::vector<std::unique_ptr<Effect>> effects;
  effects.push_back(test::tension());
  effects.push_back(std::make_unique<Diffusion>(10));
  effects.push_back(std::make_unique<Growth>(0.5));
  effects.push_back(std::move(saboteur));
  SimulationParts parts = test::parts(std::move(effects), integrator);
  parts.constraints.push_back(std::move(constraint));
  Simulation simulation(two_bubbles(2, 0.05), options, std::move(parts));
  approach(simulation.mesh(), 0.05, 0.5, simulation.circulation());
  return {effect, held, std::move(simulation)};
}

std::vector<std::uint8_t> bits(const Simulation& simulation) {
  return nlohmann::json::to_cbor(to_json(simulation.state()));
}

class FailedStep : public testing::TestWithParam<std::tuple<Where, const char*>> {};

TEST_P(FailedStep, LeavesEveryBitAndCanBeMadeAgain) {
  constexpr long good = 4, all = 14;
  const auto [where, integrator] = GetParam();
  Meeting failing = meeting(where, good, integrator), never = meeting(Where::attach_only, good, integrator);
  for (long i = 0; i < good; ++i) failing.simulation.step();
  const auto before = bits(failing.simulation);
  EXPECT_ANY_THROW(failing.simulation.step());
  EXPECT_EQ(bits(failing.simulation), before);
  EXPECT_ANY_THROW(failing.simulation.step()) << "again";
  EXPECT_EQ(bits(failing.simulation), before);
  failing.saboteur->behave();
  failing.constraint->behave();
  while (failing.simulation.steps() < all) failing.simulation.step();
  while (never.simulation.steps() < all) never.simulation.step();
  EXPECT_EQ(bits(failing.simulation), bits(never.simulation)) << "the failure has left a trace";
  EXPECT_GT(never.simulation.topology_totals().snaps, 0U) << "the bubbles have not met: too weak a test";
}

INSTANTIATE_TEST_SUITE_P(Stages, FailedStep,
                         testing::Combine(testing::Values(Where::circulation, Where::velocity, Where::positions,
                                                          Where::not_finite, Where::constraint_circulation,
                                                          Where::constraint_positions),
                                          testing::Values("euler", "rk4")));

TEST(SimulationStateTest, GoesOnFromWhereItWasTakenThroughJson) {
  Meeting one = meeting(Where::attach_only, 0, "euler"), other = meeting(Where::attach_only, 0, "euler");
  for (int i = 0; i < 9; ++i) one.simulation.step();
  const auto bytes = bits(one.simulation);
  other.simulation.restore(simulation_state_from_json(nlohmann::json::from_cbor(bytes)));
  EXPECT_EQ(bits(other.simulation), bytes);
  EXPECT_EQ(other.saboteur->count(), 9);
  for (int i = 0; i < 5; ++i) {
    one.simulation.step();
    other.simulation.step();
  }
  EXPECT_EQ(bits(other.simulation), bits(one.simulation));
}

TEST(SimulationStateTest, OfAnEffectThatIsNotThereIsRefused) {
  Meeting one = meeting(Where::attach_only, 0, "euler");
  one.simulation.step();
  Simulation without(two_bubbles(2, 0.05), {}, test::parts());
  EXPECT_THROW(without.restore(one.simulation.state()), base::InputError);
}

}  // namespace
}  // namespace foamsim
