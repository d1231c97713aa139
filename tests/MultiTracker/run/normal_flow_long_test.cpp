// Spheres pressed into a foam: every layout, number and seed has to succeed, whatever the step.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>

#include "MultiTracker/study/robustness.h"

namespace multitracker {
namespace {

RobustnessOptions options_of_study() {
  RobustnessOptions options;
  options.audit_every_step = true;
  options.time_limit = 1800;
  return options;
}

void expect_all_succeed(const RobustnessOptions& options) {
  for (const RobustnessRun& run : run_robustness(options))
    EXPECT_TRUE(run.success()) << run.key.spheres << " spheres, step " << run.key.step << " L, seed " << run.key.seed
                               << ": " << run.message;
}

class AllSucceed : public testing::TestWithParam<std::tuple<std::string, long>> {};

TEST_P(AllSucceed, ForTenSeeds) {
  RobustnessOptions options = options_of_study();
  options.layout = std::get<0>(GetParam());
  options.spheres = {std::get<1>(GetParam())};
  options.steps = {0.05};
  options.total_motion = 3;
  expect_all_succeed(options);
}

INSTANTIATE_TEST_SUITE_P(NormalFlow, AllSucceed,
                         testing::Combine(testing::Values<std::string>("grid", "random"),
                                          testing::Values(8L, 27L, 64L, 125L)),
                         [](const auto& row) {
                           return std::get<0>(row.param) + "_" + std::to_string(std::get<1>(row.param));
                         });

class SharesAsMuchArea : public testing::TestWithParam<std::pair<long, long>> {};

// 5.5 L of growth, in steps of 0.05, 0.2, 0.5 and 1 L.
TEST_P(SharesAsMuchArea, WhateverTheStep) {
  RobustnessOptions options = options_of_study();
  options.spheres = {GetParam().first};
  options.seeds = GetParam().second;
  const auto summaries = summarise(run_robustness(options));
  ASSERT_EQ(summaries.size(), 4u);
  for (const RobustnessSummary& s : summaries) {
    std::cout << "step " << s.step << " L: shared area " << s.shared_area << ", " << s.successes << " of " << s.runs
              << " succeed, " << s.cpu_seconds << " CPU s\n";
    EXPECT_EQ(s.successes, s.runs);
    EXPECT_NEAR(s.shared_area / summaries[0].shared_area, 1, 0.15) << "step " << s.step << " L";
  }
}

// Spheres and seeds.
INSTANTIATE_TEST_SUITE_P(NormalFlow, SharesAsMuchArea,
                         testing::Values(std::pair(8L, 10L), std::pair(27L, 3L), std::pair(64L, 1L)),
                         [](const auto& row) { return std::to_string(row.param.first); });

}  // namespace
}  // namespace multitracker
