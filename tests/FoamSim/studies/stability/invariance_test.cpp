// The same bubbles in other units of length and elsewhere move alike.
#include <gtest/gtest.h>

#include <cstdio>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "FoamSim/studies/stability/stability_study.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

class Invariance : public testing::TestWithParam<std::string> {};

StabilityRow run(const char* name, const std::string& area, bool remeshing) {
  return *run_stability_case(stability_case_by_name(name), {area, remeshing, 0.4}, 300, {});
}

// Powers of two change no digit: any difference would come from a length that is written in the code as a number.
TEST_P(Invariance, LengthsTimesPowersOfTwo) {
  for (bool remeshing : {true, false}) {
    const StabilityRow row = run("scaled", GetParam(), remeshing);
    EXPECT_TRUE(row.verdict.passed) << row.verdict.reason;
    EXPECT_LE(row.verdict.figure.value(), 1e-12);
    EXPECT_EQ(row.steps, 3 * 80);
  }
}

TEST_P(Invariance, EverythingMovedByAThousandRadii) {
  for (bool remeshing : {true, false}) {
    const StabilityRow row = run("moved", GetParam(), remeshing);
    EXPECT_TRUE(row.verdict.passed) << row.verdict.reason;
    EXPECT_LE(row.verdict.figure.value(), 1e-6);
    EXPECT_GT(row.verdict.figure.value(), 0) << "rounding differs there: nothing was moved";
  }
}

// The same with slivers, an unstable step and hence collisions, whose tolerances are lengths too.
TEST(InvarianceOfCollisions, LengthsTimesPowersOfTwo) {
  auto motion = [](double scale) {
    lostopos::SurfaceMesh mesh = double_bubble(8);
    press_slivers(mesh, 0.02 * lostopos::mean_edge_length(mesh));
    transform(mesh, scale, lostopos::Vec3::Zero());
    return record([&] { return simulated({}, mesh.clone(), {.dt = 0.15, .sigma = scale * scale * scale}); },
                  {.steps = 60});
  };
  const Trajectory one = motion(1);
  std::size_t collisions = 0, zones = 0;
  for (const Metrics& m : one.samples) {
    collisions += m.collisions;
    zones += m.impact_zones;
  }
  std::printf("%ld steps, %zu collisions, %zu impact zones %s\n", one.steps(), collisions, zones, one.error.c_str());
  ASSERT_GT(collisions, 0U);
  for (double scale : {0x1p20, 0x1p-20})
    EXPECT_LE(largest_difference(one, motion(scale), scale, lostopos::Vec3::Zero()), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Area, Invariance, testing::Values("naive", "constant-edge", "averaged"), [](const auto& info) {
  return info.param == "constant-edge" ? std::string("constant_edge") : info.param;
});

}  // namespace
}  // namespace foamsim
