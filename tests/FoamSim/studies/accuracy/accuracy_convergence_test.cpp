// Double bubbles brought to rest with `averaged`: what the study reports falls with the size of the triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "FoamSim/studies/accuracy/accuracy_study.h"

namespace foamsim {
namespace {

TEST(AccuracyConvergence, ErrorsOfAveragedFallWithN) {
  const auto rows =
      study_accuracy({.areas = {"averaged"}, .sizes = {8, 16, 32}, .integrators = {"euler"}, .steps_of_time = {0.02}});
  ASSERT_EQ(rows.size(), 3U);
  for (const AccuracyRow& row : rows) {
    ASSERT_TRUE(row.errors.has_value()) << row.reason;
    std::printf(
        "N = %ld, %zu triangles, %s at %g: area %.4f%%, radius %.3f%%, wall %.2f%%, facets %.3f deg, films %.3f deg\n",
        row.n, row.triangles, row.ended.c_str(), row.time, 100 * row.errors->area, 100 * row.errors->radius,
        100 * row.errors->wall, row.errors->angle_rms_deg.value(), row.errors->angle_rms_film_deg.value());
    EXPECT_GT(row.errors->area, 0) << "the closed form has the least area of all";
    EXPECT_LT(row.volume_drift, 0.02);
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LT(rows[i].errors->area, 0.6 * rows[i - 1].errors->area);
    EXPECT_LT(rows[i].errors->angle_rms_deg, rows[i - 1].errors->angle_rms_deg);
  }
  EXPECT_LT(rows[2].errors->angle_rms_deg.value(), 0.5 * rows[0].errors->angle_rms_deg.value());
}

TEST(AccuracyConvergence, AveragedIsNearerToTheClosedFormThanConstantEdge) {
  const auto rows = study_accuracy(
      {.areas = {"averaged", "constant-edge"}, .sizes = {16}, .integrators = {"euler"}, .steps_of_time = {0.02}});
  ASSERT_EQ(rows.size(), 2U);
  const EquilibriumErrors &averaged = rows[0].errors.value(), &constant = rows[1].errors.value();
  EXPECT_LT(averaged.area, 0.7 * constant.area);
  EXPECT_LT(std::abs(averaged.radius), 0.7 * std::abs(constant.radius));
  EXPECT_LT(averaged.angle_rms_deg.value(), 0.7 * constant.angle_rms_deg.value());
}

}  // namespace
}  // namespace foamsim
