#include "FoamSim/dynamics/integrator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "Base/error.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

// Rotation about z with an angular velocity that depends on the radius: circles, but not linear.
Vec3 swirl(const Vec3& x) {
  const double omega = 1 + x.head<2>().squaredNorm();
  return {-omega * x.y(), omega * x.x(), 0.3 * x.z()};
}

Vec3 exact_swirl(const Vec3& x, double t) {
  const double angle = (1 + x.head<2>().squaredNorm()) * t;
  return {x.x() * std::cos(angle) - x.y() * std::sin(angle), x.x() * std::sin(angle) + x.y() * std::cos(angle),
          x.z() * std::exp(0.3 * t)};
}

// A motion with this velocity, whose positions nobody corrects.
StageMotion uncorrected(const std::function<void(std::span<const Vec3>, std::span<Vec3>)>& velocity) {
  return {.velocity = [velocity](double, std::span<const Vec3> x, std::span<Vec3> u) { velocity(x, u); },
          .correct = [](double, std::span<Vec3>) {}};
}

double error_after_one_unit_of_time(const char* name, int steps) {
  const std::vector<Vec3> start{{0.5, 0.2, 1}, {-0.1, 0.9, -2}, {0, 0, 0.5}};
  const double dt = 1.0 / steps;
  const auto velocity = [](std::span<const Vec3> x, std::span<Vec3> u) {
    for (std::size_t i = 0; i < x.size(); ++i) u[i] = swirl(x[i]);
  };
  const auto integrator = make_integrator(name);
  std::vector<Vec3> x = start, u(start.size()), predicted;
  for (int i = 0; i < steps; ++i) {
    velocity(x, u);
    integrator->advance(dt, x, u, uncorrected(velocity), predicted);
    x = predicted;
  }
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, (x[i] - exact_swirl(start[i], 1)).norm());
  return largest;
}

TEST(Integrators, EulerIsOfFirstOrder) {
  for (int steps : {40, 80, 160})
    EXPECT_NEAR(
        std::log2(error_after_one_unit_of_time("euler", steps) / error_after_one_unit_of_time("euler", 2 * steps)), 1,
        0.1);
}

TEST(Integrators, Rk4IsOfFourthOrder) {
  for (int steps : {20, 40, 80})
    EXPECT_NEAR(std::log2(error_after_one_unit_of_time("rk4", steps) / error_after_one_unit_of_time("rk4", 2 * steps)),
                4, 0.15);
  EXPECT_LT(error_after_one_unit_of_time("rk4", 100), 1e-7);
}

TEST(Integrators, Rk4TakesTheTaylorSeriesToTheFourthOrder) {
  // x' = x: one step gives 1 + h + h²/2 + h³/6 + h⁴/24, Euler's 1 + h.
  const std::vector<Vec3> x{{1, -2, 4}};
  const std::vector<Vec3>& u = x;
  const auto velocity = [](std::span<const Vec3> at, std::span<Vec3> out) { std::ranges::copy(at, out.begin()); };
  std::vector<Vec3> predicted;
  constexpr double h = 0.5;
  make_integrator("rk4")->advance(h, x, u, uncorrected(velocity), predicted);
  EXPECT_LT((predicted[0] - x[0] * (1 + h + h * h / 2 + h * h * h / 6 + h * h * h * h / 24)).norm(), 1e-15);
  make_integrator("euler")->advance(h, x, u, uncorrected(velocity), predicted);
  EXPECT_EQ(predicted[0], Vec3(1.5, -3, 6));
}

TEST(Integrators, EvaluateTheVelocityNoMoreOftenThanTheySay) {
  for (const auto& [integrator, expected] : {std::pair("euler", 0), std::pair("rk4", 3)}) {
    int calls = 0;
    const std::vector<Vec3> x(2, Vec3::Zero());
    const std::vector<Vec3>& u = x;
    std::vector<Vec3> predicted;
    make_integrator(integrator)
        ->advance(0.1, x, u, uncorrected([&calls](std::span<const Vec3>, std::span<Vec3> out) {
                    ++calls;
                    std::ranges::fill(out, Vec3::Zero());
                  }),
                  predicted);
    EXPECT_EQ(calls, expected);
  }
}

TEST(Integrators, LetPositionsBeCorrectedAtEveryStage) {
  for (const auto& [integrator, expected] :
       {std::pair("euler", std::vector{0.5}), std::pair("rk4", std::vector{0.25, 0.25, 0.5, 0.5})}) {
    std::vector<double> instants;
    const StageMotion motion{
        .velocity = [](double, std::span<const Vec3>, std::span<Vec3> u) { std::ranges::fill(u, Vec3(1, 0, 0)); },
        .correct =
            [&instants](double after, std::span<Vec3> x) {
              instants.push_back(after);
              x[0].y() = 7;
            }};
    const std::vector<Vec3> x(1, Vec3::Zero()), u(1, Vec3(1, 0, 0));
    std::vector<Vec3> predicted;
    make_integrator(integrator)->advance(0.5, x, u, motion, predicted);
    EXPECT_EQ(instants, expected) << integrator;
    EXPECT_EQ(predicted[0], Vec3(0.5, 7, 0)) << integrator;
  }
}

TEST(Integrators, AreFoundByName) {
  EXPECT_EQ(integrators().names(), (std::vector<std::string>{"euler", "rk4", "implicit", "pbd"}));
  try {
    make_integrator("rk5");
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'rk4'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foamsim
