#pragma once

#include <span>

#include "FoamSim/sheet/sheet_strength.h"

namespace foamsim {

/// Kinetic energy of the air over its density, K = −Σ_t Γ̄_t (u·n) area_t (docs/method.md "The step"; u the mean of the
/// corners' velocities), L⁵/T².
///
/// `circulation`: Γ̄_t (L²/T) for each triangle of `sheet`, from circulation_without_region_constants. Given that of
/// one instant and the velocity of another, near one, the sum is second-order accurate for the instant half-way: K is a
/// symmetric bilinear form of the two. `positions` (L) and `velocity` (L/T) are indexed by vertex handle.
double kinetic_energy(std::span<const double> circulation, std::span<const SheetTriangle> sheet,
                      std::span<const lostopos::Vec3> positions, std::span<const lostopos::Vec3> velocity);

struct Impulse {
  lostopos::Vec3 total;  ///< I = 2 Σ_t Γ̄_t area_t n, conserved without damping, diffusion and remeshing; L⁴/T
  double scale;          ///< Σ_t |2 Γ̄_t area_t|
};
/// `circulation` as above.
Impulse hydrodynamic_impulse(std::span<const double> circulation, std::span<const SheetTriangle> sheet,
                             std::span<const lostopos::Vec3> positions);

}  // namespace foamsim
