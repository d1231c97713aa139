#include "FoamSim/sheet/energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/region_constants.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

struct Measured {
  double kinetic_energy;
  Impulse impulse;
};

// With the velocity that the sheet itself induces.
Measured measure(const SurfaceMesh& mesh, const CirculationField& circulation, double delta) {
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  std::vector<Vec3> u(mesh.vertex_slots());
  SheetVelocity(make_biot_savart("direct")).evaluate(sheet, mesh.positions(), mesh.positions(), delta, u);
  const auto mean = circulation_without_region_constants(mesh, sheet, mesh.positions());
  return {kinetic_energy(mean, sheet, mesh.positions(), u), hydrodynamic_impulse(mean, sheet, mesh.positions())};
}

using Jump = std::function<double(const Vec3&)>;

Measured on_bubbles(SurfaceMesh mesh, const Jump& circulation_outwards, double delta_over_h = 0.75) {
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v))
      // Bubbles are 1 and 2, the air is 0: outwards is against the stored order.
      if (held.pair.low == air) held.value = -circulation_outwards(mesh.position(v));
  return measure(mesh, circulation, delta_over_h * lostopos::mean_edge_length(mesh));
}

// The unit sphere whose surface moves with the normal velocity P_n: 2Γ = −(1/n + 1/(n + 1)) P_n.
Measured sphere_in_mode(unsigned n, long subdivisions, double offset = 0) {
  return on_bubbles(icosphere(subdivisions), [n, offset](const Vec3& x) {
    return offset - 0.5 * (1.0 / n + 1.0 / (n + 1)) * std::legendre(n, x.x());
  });
}

// ½ ∮ (φ_in − φ_out) u·n = 2π / (n (n + 1)) for V = R = 1; n = 1: the ball's ⅔π and the added mass's ⅓π.
double exact_energy(unsigned n) {
  return 2 * pi / (n * (n + 1));
}

TEST(KineticEnergy, OfSphericalModesTendsToThatOfPotentialFlow) {
  for (unsigned n : {1U, 2U, 3U}) {
    double last = 0, before_last = 0;
    for (long subdivisions : {2L, 3L, 4L}) {
      const double error = 1 - sphere_in_mode(n, subdivisions).kinetic_energy / exact_energy(n);
      EXPECT_GT(error, 0) << "the regularisation takes energy away";
      if (subdivisions > 2) {
        EXPECT_GT(std::log2(last / error), subdivisions == 3 ? 0.75 : 0.85) << n;
      }
      before_last = last;
      last = error;
    }
    EXPECT_LT(last, 0.06 * (n + 0.5)) << n;
    EXPECT_LT(std::abs(last - (before_last - last)), 0.02) << n << ": extrapolated to zero h and delta";
  }
}

TEST(KineticEnergy, DoesNotSeeAConstantPotential) {
  const double without = sphere_in_mode(2, 3).kinetic_energy;
  // A bubble's pressure adds 4 to Γ in a unit of time.
  for (double offset : {1.0, -40.0, 1000.0})
    EXPECT_NEAR(sphere_in_mode(2, 3, offset).kinetic_energy / without, 1, 1e-10) << offset;
}

TEST(KineticEnergy, ConstantsOfSeveralRegionsGoUnseenToo) {
  SurfaceMesh mesh = double_bubble(12);
  CirculationField circulation(mesh);
  // Γ^{pq} = g_p − g_q from one potential a region, so that the three films of a border fit together.
  auto set = [&](double c1, double c2) {
    auto g = [&](Region r, const Vec3& x) {
      const double constant = r == Region(1) ? c1 : r == Region(2) ? c2 : 0;
      return constant + 0.3 * x.x() * (r.index() + 1.0) + 0.2 * x.y() * x.z();
    };
    for (Vertex v : mesh.vertices())
      for (PairCirculation& held : circulation.at(v))
        held.value = g(held.pair.low, mesh.position(v)) - g(held.pair.high, mesh.position(v));
    return measure(mesh, circulation, 0.2);
  };
  const Measured without = set(0, 0), with = set(17, -90);
  EXPECT_GT(without.kinetic_energy, 0);
  EXPECT_NEAR(with.kinetic_energy / without.kinetic_energy, 1, 1e-9);
  EXPECT_LT((with.impulse.total - without.impulse.total).norm(), 1e-9);
  EXPECT_NEAR(with.impulse.scale / without.impulse.scale, 1, 1e-9);
}

TEST(KineticEnergy, IsNeverNegative) {
  std::mt19937 random(20240521);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    // Smooth: a random polynomial; rough: a random value a vertex.
    const Vec3 a(normal(random), normal(random), normal(random)), b(normal(random), normal(random), normal(random));
    const double smooth = on_bubbles(double_bubble(12), [&](const Vec3& x) {
                            return a.dot(x) + b.dot(x) * b.dot(x) + a.dot(x) * b.dot(x) * x.x();
                          }).kinetic_energy;
    EXPECT_GT(smooth, 0);
    const double rough = on_bubbles(double_bubble(12), [&](const Vec3&) { return normal(random); }).kinetic_energy;
    EXPECT_GT(rough, 0);
  }
}

TEST(KineticEnergy, OfNothingIsZero) {
  EXPECT_EQ(on_bubbles(icosphere(1), [](const Vec3&) { return 0.0; }).kinetic_energy, 0);
}

TEST(HydrodynamicImpulse, OfATranslatingSphereTendsToItsMomentum) {
  // 2Γ = −(3/2) V x; the ball's 4π/3 and the added mass's 2π/3 move with V: |I| = 2π V. Normals point outwards and
  // 2Γ is the potential outside less that inside, so that I = 2 Σ Γ̄ area n points against the motion.
  double last = 0;
  for (long subdivisions : {2L, 3L, 4L}) {
    const Impulse impulse = sphere_in_mode(1, subdivisions).impulse;
    const double error = std::abs(impulse.total.x() / (-2 * pi) - 1);
    EXPECT_LT(impulse.total.tail<2>().norm(), 1e-13);
    if (subdivisions > 2) {
      EXPECT_NEAR(last / error, 4, 0.2) << "second order; the regularisation has no part in it";
    }
    last = error;
  }
  EXPECT_LT(last, 0.004);
}

TEST(HydrodynamicImpulse, ScaleIsTheSumOfTheSizesOfItsParts) {
  // ∮ |(3/2) x| dA = 3π for the same sphere.
  EXPECT_NEAR(sphere_in_mode(1, 4).impulse.scale / (3 * pi), 1, 0.005);
}

TEST(HydrodynamicImpulse, OfAModeWithoutNetMotionIsZero) {
  const Impulse impulse = sphere_in_mode(2, 3).impulse;
  EXPECT_LT(impulse.total.norm(), 1e-13 * impulse.scale);
}

}  // namespace
}  // namespace foamsim
