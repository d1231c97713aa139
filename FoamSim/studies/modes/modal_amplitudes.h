#pragma once

#include <array>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Legendre polynomials P_0 … P_6 are fitted.
inline constexpr std::size_t fitted_modes = 7;

/// The coefficients a_n (L) of r(θ) = Σ_n a_n P_n(cos θ) that fit the surface's vertices best, weighted by a third of
/// the area around each: r the distance from the origin, θ the angle to the x axis. For a sphere of radius R about the
/// origin a_0 = R and the others 0.
std::array<double, fitted_modes> modal_amplitudes(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
