// Vortex rings, whose velocity is known in closed form.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "FoamSim/sheet/velocity/biot_savart.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace foamsim {
namespace {

using lostopos::Vec3;
using std::numbers::pi;

constexpr double kRadius = 1.3;
constexpr double kCirculation = 0.7;

// n straight segments inscribed in the ring about +z: each a source at its midpoint, second order in 1/n.
VortexSources polygonal_ring(int n) {
  const auto corner = [n](int i) {
    return Vec3(kRadius * std::cos(2 * pi * i / n), kRadius * std::sin(2 * pi * i / n), 0);
  };
  VortexSources sources;
  sources.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const Vec3 a = corner(i);
    const Vec3 b = corner(i + 1);
    sources.set(static_cast<std::size_t>(i), (a + b) / 2, kCirculation * (b - a));
  }
  return sources;
}

// The trapezoidal rule on the ring itself, sources at half-steps: spectrally accurate for δ > 0.
VortexSources smooth_ring(int n) {
  VortexSources sources;
  sources.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * pi * (i + 0.5) / n;
    const Vec3 tangent(-std::sin(phi), std::cos(phi), 0);
    sources.set(static_cast<std::size_t>(i), kRadius * Vec3(std::cos(phi), std::sin(phi), 0),
                kCirculation * kRadius * 2 * pi / n * tangent);
  }
  return sources;
}

Vec3 velocity(const VortexSources& sources, const Vec3& x, double delta) {
  Vec3 u(0, 0, 0);
  make_biot_savart("direct")->velocities(sources, {&x, 1}, delta, {&u, 1});
  return u;
}

// On the ring, |x − m|² = 2R²(1 − cos φ) and (dl × (x − m))_z = R²(1 − cos φ) dφ, so with φ = π − 2θ, a² = 4R² + δ²,
// k = 2R/a, and ∫₀^{π/2} cos²θ (1 − k² sin²θ)^{-3/2} dθ = (K(k) − E(k))/k² = R_D(0, 1 − k², 1)/3:
//   U = Γ (K − E) / (2π a) = 2 Γ R² R_D / (3π a³).
// Carlson's R_D because 1 − k² = δ²/a² would lose its digits through k in a thin ring.
double translation_speed(double delta) {
  const double a = std::hypot(2 * kRadius, delta);
  const double rd = boost::math::ellint_rd(0.0, delta * delta / (a * a), 1.0);
  return 2 * kCirculation * kRadius * kRadius * rd / (3 * pi * a * a * a);
}

double thin_ring_speed(double delta) {
  return kCirculation / (4 * pi * kRadius) * (std::log(8 * kRadius / delta) - 1);
}

TEST(VortexRing, AxisVelocityConvergesAtSecondOrder) {
  for (const double z : {0.0, 0.4, -2.5}) {
    const double exact = kCirculation * kRadius * kRadius / (2 * std::pow(kRadius * kRadius + z * z, 1.5));
    double coarse = 0;
    for (int n = 16; n <= 1024; n *= 4) {
      const Vec3 u = velocity(polygonal_ring(n), Vec3(0, 0, z), 0);
      EXPECT_LE(std::hypot(u.x(), u.y()), 1e-15) << "z = " << z << ", n = " << n;
      const double error = std::abs(u.z() - exact) / exact;
      EXPECT_LE(error, 20.0 / (n * n)) << "z = " << z << ", n = " << n;
      if (coarse > 0) {
        EXPECT_NEAR(std::log2(coarse / error) / 2, 2, 0.05) << "z = " << z << ", n = " << n;
      }
      coarse = error;
    }
  }
}

TEST(VortexRing, RegularisedRingMovesAtTheClosedFormSpeed) {
  for (const double delta : {0.05, 0.3, 1.0, 5.0}) {
    const double exact = translation_speed(delta);
    const VortexSources ring = smooth_ring(2000);
    for (const double phi : {0.0, 1.0, 4.0}) {
      const Vec3 u = velocity(ring, kRadius * Vec3(std::cos(phi), std::sin(phi), 0), delta);
      EXPECT_NEAR(u.z() / exact, 1, 1e-12) << "delta = " << delta << ", phi = " << phi;
      EXPECT_LE(std::hypot(u.x(), u.y()), 1e-15) << "delta = " << delta << ", phi = " << phi;
    }
  }
}

// δ → 0: U → Γ/(4πR) (ln(8R/δ) − 1), with an error of order δ² ln δ.
TEST(VortexRing, ThinRegularisedRingMovesAtTheAsymptoticSpeed) {
  for (const double delta : {0.02, 0.005}) {
    const Vec3 u = velocity(smooth_ring(static_cast<int>(60 / delta)), Vec3(kRadius, 0, 0), delta);
    EXPECT_NEAR(u.z() / thin_ring_speed(delta), 1, delta * delta) << "delta = " << delta;
    EXPECT_NEAR(u.z() / translation_speed(delta), 1, 1e-12) << "delta = " << delta;
  }
}

}  // namespace
}  // namespace foamsim
