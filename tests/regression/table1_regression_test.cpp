// The report's table at its two coarse resolutions, and what it is there to show.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "FoamSim/studies/reproduce/table1.h"
#include "tests/regression/reference_store.h"

namespace foamsim {
namespace {

std::vector<Table1Row> coarse_rows() {
  Table1Settings settings;
  settings.subdivisions = {16, 24};
  settings.areas = {"averaged", "constant-edge"};
  settings.out = testing::TempDir() + "foamsim-regression-" + std::to_string(getpid());
  auto rows = make_table1(settings);
  std::filesystem::remove_all(settings.out);
  return rows;
}

const Table1Row& row(const std::vector<Table1Row>& rows, const std::string& area, long n) {
  return *std::ranges::find_if(rows, [&](const Table1Row& r) { return r.area == area && r.n == n; });
}

TEST(Table1Regression, RestAnglesOfTheTwoStableStrategies) {
  const std::vector<Table1Row> rows = coarse_rows();
  ASSERT_EQ(rows.size(), 4U);
  for (const Table1Row& r : rows) {
    std::printf("%s, N = %ld: facets %.3f, films %.3f degrees after %ld steps, %s\n", r.area.c_str(), r.n,
                r.angle_rms_deg.value(), r.angle_rms_film_deg.value(), r.steps, r.ended.c_str());
    EXPECT_EQ(r.ended, "at rest") << r.area << r.n;
    EXPECT_LT(r.volume_drift_max, 0.01);
    const std::string name = "table1." + r.area + "." + std::to_string(r.n);
    test::expect_stored(name + ".rms", *r.angle_rms_deg);
    test::expect_stored(name + ".films_rms", *r.angle_rms_film_deg);
    if (r.area == "averaged") {
      EXPECT_LE(std::abs(r.difference_deg().value()), 1.5) << "published: " << *r.published_deg;
    }
  }
  for (long n : {16L, 24L}) {
    const Table1Row &averaged = row(rows, "averaged", n), &constant = row(rows, "constant-edge", n);
    const double ratio = *constant.angle_rms_deg / *averaged.angle_rms_deg;
    EXPECT_GE(ratio, 2) << n;
    EXPECT_LE(ratio, 3) << n;
    EXPECT_GT(*constant.angle_rms_film_deg, 2 * *averaged.angle_rms_film_deg) << n;
  }
  EXPECT_GE(observed_order(row(rows, "averaged", 16), row(rows, "averaged", 24)).value(), 0.8);
}

}  // namespace
}  // namespace foamsim
