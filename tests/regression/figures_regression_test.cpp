// The report's figures 1 and 3 in numbers, and the angle measures' own error.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "FoamSim/studies/reproduce/angle_measures.h"
#include "FoamSim/studies/reproduce/report_scene.h"
#include "FoamSim/studies/reproduce/stretched_junction.h"
#include "LosTopos/mesh/measures.h"
#include "tests/regression/reference_store.h"

namespace foamsim {
namespace {

double centroid_drift(const std::string& area, double time) {
  Simulation simulation = make_simulation(report_scene(16, area));
  const lostopos::Vec3 start = lostopos::surface_centroid(simulation.mesh());
  while (simulation.time() < time) simulation.step();
  return (lostopos::surface_centroid(simulation.mesh()) - start).norm();
}

TEST(FiguresRegression, NaiveDriftsSeveralTimesAsFarAsAveraged) {
  constexpr double time = 15;
  const double naive = centroid_drift("naive", time), averaged = centroid_drift("averaged", time);
  std::printf("drift by time %g: naive %.4f, averaged %.4f\n", time, naive, averaged);
  test::expect_stored("figure1.naive.drift", naive);
  test::expect_stored("figure1.averaged.drift", averaged);
  EXPECT_GT(naive, 3 * averaged);
}

TEST(FiguresRegression, AStretchedFilmUnbalancesNaiveOnly) {
  for (const StretchedJunctionRow& row : stretch_junction({2})) {
    test::expect_stored("figure3." + row.area + ".imbalance", row.imbalance());
    if (row.area == "averaged") test::expect_stored("figure3.averaged.curvature", row.curvature[0]);
  }
}

TEST(FiguresRegression, TheMeasuresOwnErrors) {
  const auto rows = measure_exact_double_bubbles();
  for (const MeasuredExactly& r : rows) {
    const std::string name =
        "measures." + std::to_string(static_cast<int>(r.volume_ratio)) + "." + std::to_string(r.segments);
    if (r.volume_ratio == 1) test::expect_stored(name + ".facets", r.facets_rms_deg);
    if (r.volume_ratio == 2 && (r.segments == 16 || r.segments == 96))
      test::expect_stored(name + ".films", r.films_rms_deg);
  }
  EXPECT_GE(film_order(rows[0], rows[3]), 1.8) << "equal volumes";
  EXPECT_GE(film_order(rows[4], rows[7]), 1.8) << "volumes 1 and 2";
}

}  // namespace
}  // namespace foamsim
