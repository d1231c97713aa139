// Elastic rods: their energies' derivatives, the shapes in which they rest, and how they carry films.
#include "FoamSim/constraints/rod.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Hold;
using lostopos::Vec3;
using lostopos::Vertex;

class RodDerivatives : public testing::TestWithParam<bool> {};

TEST_P(RodDerivatives, AreThoseOfTheEnergy) {
  const bool closed = GetParam();
  constexpr std::size_t n = 6;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-0.2, 0.2);
  std::vector<Vec3> x;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = static_cast<double>(i);
    x.emplace_back(std::cos(angle) + any(random), std::sin(angle) + any(random), any(random));
  }
  std::vector<double> lengths;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) lengths.push_back(0.8 + any(random));
  const RodChain rod(lengths, closed, std::vector<char>(n, 0),
                     {.radius = 0.3, .density = 2, .stretching = 7, .bending = 3, .gravity = 1.5});
  const std::vector<RodFilm> films{
      {1, {0, 0, 1}, {0.3, 0.2, 0}}, {1, {0, 0, 0}, {0.3, 0.2, 0}}, {4, {0, 1, 1}, {1, 0, 0}}};
  constexpr double pull = 2.5, h = 1e-5;
  const Eigen::VectorXd gradient = rod.gradient(x, pull, films);
  const Eigen::MatrixXd hessian = rod.hessian(x, pull, films);
  for (Eigen::Index i = 0; i < gradient.size(); ++i) {
    auto up = x, down = x;
    up[static_cast<std::size_t>(i) / 3][i % 3] += h;
    down[static_cast<std::size_t>(i) / 3][i % 3] -= h;
    EXPECT_NEAR(gradient[i], (rod.energy(up, pull, films) - rod.energy(down, pull, films)) / (2 * h), 1e-7);
    const Eigen::VectorXd column = (rod.gradient(up, pull, films) - rod.gradient(down, pull, films)) / (2 * h);
    for (Eigen::Index j = 0; j < column.size(); ++j) EXPECT_NEAR(hessian(j, i), column[j], 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(ClosedAndOpen, RodDerivatives, testing::Bool());

// B θ″ = −w (L − s) cos θ for the angle θ below the horizontal, θ(0) = 0, θ′(L) = 0: a heavy elastica that is clamped
// at one end. Returns where its free end is.
Eigen::Vector2d hanging_end(double stiffness, double weight, double length) {
  constexpr int steps = 2000;
  Eigen::Vector2d end;
  const auto last_slope = [&](double slope) {
    const double h = length / steps;
    double angle = 0;
    end.setZero();
    for (int i = 0; i < steps; ++i) {
      const double s = i * h;
      const auto bend = [&](double at, double a) { return -weight / stiffness * (length - at) * std::cos(a); };
      const double middle = angle + h / 2 * slope + h * h / 8 * bend(s, angle);
      end += h * Eigen::Vector2d(std::cos(middle), -std::sin(middle));
      const double k = bend(s + h / 2, middle);
      angle += h * slope + h * h / 2 * k;
      slope += h * k;
    }
    return slope;
  };
  double low = 0, high = weight * length * length / stiffness;
  for (int i = 0; i < 60; ++i) (last_slope((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  return end;
}

TEST(RodAtRest, IsTheElasticaOfAHangingChain) {
  constexpr int segments = 60;
  constexpr double length = 1, piece = length / segments, weight = 8, stiffness = 1;
  std::vector<char> fixed(segments + 1, 0);
  fixed[0] = fixed[1] = 1;
  const RodChain rod(std::vector<double>(segments, piece), false, fixed,
                     {.radius = 1,
                      .density = 1 / std::numbers::pi,
                      .stretching = 1e6,
                      .bending = stiffness / (piece * piece * piece),
                      .damping = 0,
                      .gravity = weight});
  RodChain::Points x, v(segments + 1, Vec3::Zero());
  for (int i = 0; i <= segments; ++i) x.emplace_back(i * piece, 0, 0);
  for (int i = 0; i < 600; ++i) rod.advance(0.2, RodScheme::implicit, 0, {}, x, v);
  for (const Vec3& velocity : v) EXPECT_LT(velocity.norm(), 1e-6);
  // What is clamped is the first segment: its middle is where the curve begins.
  const Eigen::Vector2d exact = hanging_end(stiffness, weight, length - piece / 2);
  EXPECT_LT(exact.y(), -0.5) << "not bent by much: too weak a test";
  EXPECT_NEAR(x.back().x(), exact.x() + piece / 2, 0.003);
  EXPECT_NEAR(x.back().z(), exact.y(), 0.003);
  EXPECT_EQ(x.back().y(), 0);
}

// Without weight and films nothing outside acts.
TEST(RodInMotion, KeepsItsMomentumAndComesToRestStraight) {
  constexpr std::size_t n = 12;
  const RodChain rod(std::vector<double>(n - 1, 0.1), false, std::vector<char>(n, 0),
                     {.radius = 0.1, .density = 10, .stretching = 50, .bending = 20, .damping = 0});
  RodChain::Points x, v(n, Vec3::Zero());
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    x.emplace_back(0.1 * static_cast<double>(i), 0.02 * std::sin(static_cast<double>(i)), 0);
    v[i] = Vec3(0.1, 0.3 * std::cos(static_cast<double>(i)), 0.2);
    momentum += rod.mass(i) * v[i];
  }
  for (int i = 0; i < 400; ++i) rod.advance(0.05, RodScheme::implicit, 0, {}, x, v);
  Vec3 now = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) now += rod.mass(i) * v[i];
  EXPECT_LT((now - momentum).norm(), 1e-9 * momentum.norm());
  EXPECT_LT(std::abs(rod.energy(x, 0, {})), 1e-6);
}

Simulation hexagon(const std::vector<std::string>& assignments) {
  Scene scene = built_in_scene("sheet");
  for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
  return make_simulation(scene);
}

TEST(Rod, CarriesTheBorderOfASheet) {
  for (const char* dynamics : {"dynamics=vortex-sheet", "dynamics=conservative"}) {
    Simulation simulation = hexagon({dynamics});
    std::vector<Vec3> start;
    for (Vertex v : simulation.mesh().vertices()) start.push_back(simulation.mesh().position(v));
    double work = 0;
    for (int i = 0; i < 20; ++i) work += simulation.step().wire_work;
    std::size_t held = 0, fixed = 0;
    double lowest = 0;
    for (Vertex v : simulation.mesh().vertices()) {
      if (!is_held(simulation.held()[v.index()])) continue;
      ++held;
      const auto same = std::ranges::find(start, simulation.mesh().position(v));
      if (same != start.end() && same->z() > 0.866) ++fixed;
      lowest = std::min(lowest, simulation.mesh().position(v).z());
    }
    EXPECT_EQ(held, 24U);
    EXPECT_EQ(fixed, 1U);
    EXPECT_LT(lowest, -0.8665);  // it falls
    EXPECT_TRUE(std::isfinite(work));
  }
}

TEST(Rod, GoesOnFromACheckpointToTheSameBits) {
  const auto bits = [](const Simulation& simulation) { return nlohmann::json::to_cbor(to_json(simulation.state())); };
  for (const char* dynamics : {"dynamics=vortex-sheet", "dynamics=conservative"}) {
    Simulation whole = hexagon({dynamics}), first = hexagon({dynamics});
    for (int i = 0; i < 8; ++i) whole.step();
    for (int i = 0; i < 4; ++i) first.step();
    const SimulationState state = simulation_state_from_json(nlohmann::json::from_cbor(bits(first)));
    Scene scene = built_in_scene("sheet");
    scene.options.set_assignment(dynamics, "test");
    Simulation second =
        make_simulation(scene, lostopos::SurfaceMesh::from_state(state.tracker), first.resolution(), {});
    second.restore(state);
    for (int i = 0; i < 4; ++i) second.step();
    EXPECT_EQ(bits(second), bits(whole)) << dynamics;
  }
}

std::string refusal_of_rod(lostopos::SurfaceMesh mesh, const std::vector<Vertex>& held, bool looped) {
  try {
    lostopos::SurfaceTracker tracker(std::move(mesh), {.resolution = 0.2});
    for (Vertex v : held) tracker.held()[v] = Hold::all;
    Rod({.looped = looped}, {.interior_weight = 1}).attach(tracker);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Rod, RefusesWhatIsNoChain) {
  const auto tube = [] { return lostopos::test::open_cylinder(0.5, 6, 1, 0.5); };
  const std::vector<Vertex> one_ring{Vertex(0), Vertex(1), Vertex(2), Vertex(3), Vertex(4), Vertex(5)};
  EXPECT_EQ(refusal_of_rod(tube(), one_ring, true), "");
  EXPECT_EQ(refusal_of_rod(tube(), {Vertex(0), Vertex(1), Vertex(2)}, false), "");
  EXPECT_EQ(refusal_of_rod(tube(), {Vertex(0), Vertex(1), Vertex(2)}, true),
            "the rod is looped, but its ends, vertices 2 and 0, are not joined; give --set looped=false");
  EXPECT_NE(refusal_of_rod(tube(), {}, true).find("needs three or more held vertices"), std::string::npos);
  EXPECT_NE(refusal_of_rod(tube(), {Vertex(0), Vertex(2), Vertex(3)}, false).find("has 0 neighbours"),
            std::string::npos);
  std::vector<Vertex> both = one_ring;
  for (std::uint32_t v = 6; v < 12; ++v) both.emplace_back(v);
  EXPECT_NE(refusal_of_rod(tube(), both, true).find("more than one chain: 6 of 12"), std::string::npos);
  auto without_length = tube();
  without_length.set_position(Vertex(1), without_length.position(Vertex(0)));
  EXPECT_NE(refusal_of_rod(std::move(without_length), one_ring, true).find("no length between vertices 0 and 1"),
            std::string::npos);
}

}  // namespace
}  // namespace foamsim
