#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/studies/accuracy/accuracy_csv.h"
#include "FoamSim/studies/accuracy/accuracy_study.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim {
namespace {

EquilibriumErrors errors_of_exact(double volume1, double volume2, long segments) {
  return equilibrium_errors(exact_double_bubble(double_bubble_equilibrium(volume1, volume2), segments));
}

// On a surface that is sampled exactly every measure's own error falls with h².
TEST(EquilibriumErrorsTest, AreOfSecondOrderOnExactDoubleBubbles) {
  for (const auto& [volume1, volume2] : {std::pair{1.0, 1.0}, std::pair{1.0, 2.0}, std::pair{3.0, 1.0}}) {
    const EquilibriumErrors coarse = errors_of_exact(volume1, volume2, 24),
                            fine = errors_of_exact(volume1, volume2, 48);
    for (double EquilibriumErrors::*error :
         {&EquilibriumErrors::area, &EquilibriumErrors::radius, &EquilibriumErrors::rim}) {
      EXPECT_LT(std::abs(coarse.*error), 0.01);
      EXPECT_NEAR(coarse.*error / fine.*error, 4, 0.6);
    }
    // The wall's own loss and that of the volumes nearly cancel.
    EXPECT_LT(std::abs(coarse.wall), 0.002);
    EXPECT_LT(std::abs(fine.wall), std::abs(coarse.wall) / 2);
    EXPECT_LT(std::abs(fine.pressure), 0.02);
    EXPECT_LT(std::abs(fine.pressure), 0.6 * std::abs(coarse.pressure));
  }
}

TEST(EquilibriumErrorsTest, SeeAStretchedBubble) {
  lostopos::SurfaceMesh mesh = exact_double_bubble(double_bubble_equilibrium(1, 1), 48);
  for (lostopos::Vertex v : mesh.vertices()) {
    const lostopos::Vec3 x = mesh.position(v);
    mesh.set_position(v, {x.x(), 1.1 * x.y(), 1.1 * x.z()});
  }
  const EquilibriumErrors errors = equilibrium_errors(mesh);
  // The volume grows by 1.1², the unit of length with it.
  const double length = std::cbrt(1.21);
  EXPECT_NEAR(errors.rim, 1.1 / length - 1, 3e-3);
  EXPECT_NEAR(errors.wall, 1.21 / (length * length) - 1, 6e-3);
  EXPECT_GT(errors.area, 1e-3) << "no other shape has less area";
  EXPECT_GT(errors.angle_rms_film_deg.value(), 3);
}

TEST(EquilibriumErrorsTest, RefuseWhatIsNoDoubleBubble) {
  EXPECT_THROW(equilibrium_errors(lostopos::icosphere(1)), base::InputError);
}

TEST(AccuracyStudy, ChecksItsOptions) {
  using Options = AccuracyOptions;
  EXPECT_NO_THROW(validate(Options{}));
  for (const Options& bad : {Options{.areas = {}}, Options{.areas = {"average"}}, Options{.sizes = {}},
                             Options{.sizes = {7}}, Options{.sizes = {1000}}, Options{.integrators = {"rk3"}},
                             Options{.integrators = {}}, Options{.steps_of_time = {}}, Options{.steps_of_time = {0}},
                             Options{.damping = 0}, Options{.damping = 2}, Options{.most_time = 0}})
    EXPECT_THROW(study_accuracy(bad), base::InputError);
}

TEST(AccuracyStudy, HasARowForEveryCombinationAndCanBeStopped) {
  const AccuracyOptions options{.areas = {"averaged", "naive"},
                                .sizes = {8},
                                .integrators = {"euler", "rk4"},
                                .steps_of_time = {0.04},
                                .most_time = 0.4};
  double last = 0;
  const auto rows = study_accuracy(options, {.row = {},
                                             .progress =
                                                 [&](const std::string&, double fraction) {
                                                   EXPECT_GE(fraction, last);
                                                   last = fraction;
                                                 },
                                             .interrupted = {}});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_NEAR(last, 1, 1e-9);
  for (const AccuracyRow& row : rows) {
    EXPECT_EQ(row.ended, "not at rest");
    EXPECT_EQ(row.steps, 10);
    EXPECT_GT(row.cpu_seconds, 0);
    EXPECT_GT(row.stages.seconds("velocity"), 0);
    EXPECT_EQ(std::ranges::count(accuracy_csv_row(row), ','), std::ranges::count(accuracy_csv_header(), ','));
  }
  EXPECT_TRUE(study_accuracy(options, {.row = {}, .progress = {}, .interrupted = [] { return true; }}).empty());
}

}  // namespace
}  // namespace foamsim
