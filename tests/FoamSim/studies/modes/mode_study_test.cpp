#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/studies/modes/modal_amplitudes.h"
#include "FoamSim/studies/modes/mode_csv.h"
#include "FoamSim/studies/modes/mode_oscillation.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

TEST(ModalAmplitudes, FindTheModesThatASurfaceIsMadeOf) {
  SurfaceMesh mesh = lostopos::icosphere(3, 2);
  const std::array<double, fitted_modes> coefficients{0.1, -0.03, 0.05, 0.02, -0.01, 0.04, 0.005};
  for (Vertex v : mesh.vertices()) {
    const Vec3 direction = mesh.position(v) / 2;
    double r = 2;
    for (unsigned k = 0; k < fitted_modes; ++k) r += coefficients[k] * std::legendre(k, direction.x());
    mesh.set_position(v, r * direction);
  }
  const auto found = modal_amplitudes(mesh);
  EXPECT_NEAR(found[0], 2.1, 1e-13);
  for (std::size_t k = 1; k < fitted_modes; ++k) EXPECT_NEAR(found[k], coefficients[k], 1e-13) << k;
}

TEST(ModalAmplitudes, OfASphereAreItsRadius) {
  const auto found = modal_amplitudes(lostopos::icosphere(2, 3));
  EXPECT_NEAR(found[0], 3, 1e-14);
  for (std::size_t k = 1; k < fitted_modes; ++k) EXPECT_NEAR(found[k], 0, 1e-14) << k;
}

TEST(ModeFrequency, IsThatOfAFilmBetweenEqualFluids) {
  EXPECT_DOUBLE_EQ(mode_frequency(2, 1, 1), std::sqrt(96.0 / 5));
  EXPECT_DOUBLE_EQ(mode_frequency(3, 1, 1), std::sqrt(480.0 / 7));
  EXPECT_EQ(mode_frequency(1, 1, 1), 0) << "a translation";
  EXPECT_DOUBLE_EQ(mode_frequency(2, 4, 1), 2 * mode_frequency(2, 1, 1));
  EXPECT_DOUBLE_EQ(mode_frequency(2, 1, 4), mode_frequency(2, 1, 1) / 8);
}

ModeRun coarse_run() {
  return run_mode({.mode = 2, .subdivisions = 1, .periods = 1});
}

TEST(ModeRunTest, ReportsWhatItDid) {
  double last_fraction = 0;
  const ModeRun run = run_mode({.mode = 2, .subdivisions = 2, .periods = 2}, [&](const ModeProgress& progress) {
    EXPECT_EQ(progress.triangles, 320U);
    EXPECT_GE(progress.fraction, last_fraction);
    last_fraction = progress.fraction;
  });
  EXPECT_EQ(last_fraction, 1);
  EXPECT_EQ(run.triangles, 320U);
  EXPECT_EQ(run.samples.size(), static_cast<std::size_t>(run.steps));
  EXPECT_EQ(run.half_periods.size(), 4U);
  EXPECT_DOUBLE_EQ(run.delta, 0.75 * run.resolution);
  EXPECT_NEAR(run.samples.front().measured, 0.02, 1e-9);
  EXPECT_EQ(run.samples.front().measured, run.samples.front().theory);
  for (double half : run.half_periods) EXPECT_NEAR(half * run.omega / std::numbers::pi, 1, 0.01);
  EXPECT_GT(run.peak_kinetic_energy, 0);
  EXPECT_LT(run.frequency_error(), 0) << "the regularisation slows";
  EXPECT_GT(run.period_error(), 0);
}

TEST(ModeRunTest, ScalesWithRadiusAndTension) {
  const ModeRun one = coarse_run();
  const ModeRun scaled = run_mode({.mode = 2, .subdivisions = 1, .radius = 4, .sigma = 16, .periods = 1});
  EXPECT_NEAR(scaled.omega / one.omega, 0.5, 1e-9);
  EXPECT_NEAR(scaled.energy_drift, one.energy_drift, 1e-6);
}

TEST(ModeRunTest, RefusesOptionsOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ModeOptions& bad :
       {ModeOptions{.mode = 1}, ModeOptions{.mode = 7}, ModeOptions{.subdivisions = 0}, ModeOptions{.subdivisions = 8},
        ModeOptions{.amplitude = 0}, ModeOptions{.amplitude = 0.5}, ModeOptions{.radius = 0}, ModeOptions{.sigma = -1},
        ModeOptions{.sigma = nan}, ModeOptions{.dt = -1}, ModeOptions{.periods = 0}})
    EXPECT_THROW(run_mode(bad), base::InputError);
  EXPECT_THROW(study_mode({}, {2}), base::InputError);
  EXPECT_THROW(study_mode({}, {3, 2}), base::InputError);
  EXPECT_THROW(mode_convergence({}), base::InputError);
}

ModeRun made_up(double delta, double omega) {
  ModeRun run;
  run.delta = delta;
  run.omega = omega;
  run.omega_theory = 10;
  run.triangles = static_cast<std::size_t>(1 / delta);
  run.samples = {{0, 0.02, 0.02, 0, 0}, {0.25, 0.0125, 0.013, 1, -1}};
  run.peak_impulse = 1;
  run.peak_impulse_scale = 4;
  return run;
}

TEST(ModeConvergenceTest, OrdersAndExtrapolationOfKnownErrors) {
  // ω = 10 − 4δ + 2δ²: first order in the limit, and a straight line through the last two leaves −2 δ₁ δ₂.
  auto omega = [](double d) { return 10 - 4 * d + 2 * d * d; };
  const ModeConvergence c =
      mode_convergence({made_up(0.5, omega(0.5)), made_up(0.25, omega(0.25)), made_up(0.1, omega(0.1))});
  ASSERT_EQ(c.observed_orders.size(), 2U);
  EXPECT_NEAR(c.observed_orders[0], std::log2(1.5 / 0.875), 1e-12);
  EXPECT_NEAR(c.extrapolated_omega, 10 - 2 * 0.25 * 0.1, 1e-12);
  EXPECT_NEAR(c.extrapolated_error(), -0.005, 1e-12);
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(ModeCsv, HasARowASampleAndARowARun) {
  const auto folder = std::filesystem::temp_directory_path() / ("mode_csv_test_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::vector<ModeConvergence> results{mode_convergence({made_up(0.5, 8), made_up(0.25, 9)})};
  write_mode_csv(folder / "modes.csv", results);
  write_mode_summary_csv(folder / "modes_summary.csv", results);
  const auto series = lines_of(folder / "modes.csv"), summary = lines_of(folder / "modes_summary.csv");
  std::filesystem::remove_all(folder);
  ASSERT_EQ(series.size(), 5U);
  EXPECT_EQ(series[0], "mode,triangles,time,measured,theory");
  EXPECT_EQ(series[2], "2,2,0.25,0.0125,0.013");
  ASSERT_EQ(summary.size(), 4U);
  const auto columns = std::ranges::count(summary[0], ',');
  for (const std::string& line : summary) EXPECT_EQ(std::ranges::count(line, ','), columns) << line;
  EXPECT_EQ(summary[1], "2,2,0,0.5,0,8,10,-0.19999999999999996,0.25,,0,0.25");
  EXPECT_EQ(summary[2], "2,4,0,0.25,0,9,10,-0.09999999999999998,0.11111111111111116,1,0,0.25")
      << "half the error at half of delta: first order";
  EXPECT_EQ(summary[3], "2,0,0,0,,10,10,0,0,,,");
}

}  // namespace
}  // namespace foamsim
