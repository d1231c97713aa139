#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The bubbles that films alone close, and their volumes (L³). `solid` by triangle slot: not zero for those that are no
/// film; may be empty.
std::map<lostopos::Region, double> bubbles_of_films(const lostopos::SurfaceMesh& mesh,
                                                    std::span<const std::uint8_t> solid = {});

/// Pressures of bubbles above the air's, over the films' tension (both sides together; 1/L): of all
/// pressures p those with which the least of the films' pull is left,
///
///   min Σ_v |∂A/∂x_v − Σ_r p_r ∂V_r/∂x_v|² / A_v,
///
/// A_v the area around a vertex, over the vertices that are free. Where films are at rest nothing is left, and p is the
/// Lagrange multiplier of the bubble's volume: 2/R for a sphere (Young and Laplace). Vertices of free edges and of
/// solids are held by what is there, and do not count. One for each of `bubbles`, those of `bubbles_of_films`; none
/// where the sums have no solution.
std::map<lostopos::Region, double> bubble_pressures(const lostopos::SurfaceMesh& mesh,
                                                    const std::map<lostopos::Region, double>& bubbles,
                                                    std::span<const std::uint8_t> solid = {});

}  // namespace foamsim
