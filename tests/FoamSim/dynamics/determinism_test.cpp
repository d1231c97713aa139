// The same bits for any number of threads, and in every run.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <bit>
#include <cstdint>
#include <string>

#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::Vertex;

void append_bits(std::vector<std::uint64_t>& bits, double value) {
  bits.push_back(std::bit_cast<std::uint64_t>(value));
}

// Positions, circulation and what every step reports, after 50 steps of the report's double bubble.
std::vector<std::uint64_t> bits_of_a_run(std::string_view area, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  std::vector<std::unique_ptr<Effect>> effects;
  effects.push_back(test::tension(1, area));
  effects.push_back(std::make_unique<Diffusion>(10.0));
  Simulation simulation(double_bubble(16), {}, test::parts(std::move(effects)));
  std::vector<std::uint64_t> bits;
  for (int i = 0; i < 50; ++i) {
    const StepReport report = simulation.step();
    for (double value : {report.kinetic_energy, report.potential_energy, report.impulse.x(), report.impulse.y(),
                         report.impulse.z(), report.impulse_scale})
      append_bits(bits, value);
  }
  for (Vertex v : simulation.mesh().vertices()) {
    for (double coordinate : simulation.mesh().position(v)) append_bits(bits, coordinate);
    for (const PairCirculation& held : simulation.circulation().at(v)) append_bits(bits, held.value);
  }
  return bits;
}

class Determinism : public testing::TestWithParam<std::string> {};

TEST_P(Determinism, SameBitsWithOneTwoAndFiveThreadsAndInTwoRuns) {
  const auto one = bits_of_a_run(GetParam(), 1);
  ASSERT_GT(one.size(), 50U * 6 + 3U * 400);
  EXPECT_EQ(bits_of_a_run(GetParam(), 2), one);
  EXPECT_EQ(bits_of_a_run(GetParam(), 5), one);
  EXPECT_EQ(bits_of_a_run(GetParam(), 2), one) << "a second run";
}

TEST(DeterminismOfStrategies, TheyAreNotAllTheSame) {
  EXPECT_NE(bits_of_a_run("naive", 2), bits_of_a_run("averaged", 2));
  EXPECT_NE(bits_of_a_run("constant-edge", 2), bits_of_a_run("averaged", 2));
}

INSTANTIATE_TEST_SUITE_P(Area, Determinism, testing::Values("naive", "constant-edge", "averaged"),
                         [](const auto& info) { return info.param == "constant-edge" ? "constant_edge" : info.param; });

}  // namespace
}  // namespace foamsim
