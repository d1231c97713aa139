#pragma once

#include <span>
#include <vector>

#include "FoamSim/sheet/sheet_strength.h"

namespace foamsim {

/// Γ̄_t (the corners' mean, L²/T) of every triangle of the sheet, without the part that is constant over each region.
///
/// Giving every Γ^{pq} a constant c_p − c_q moves nothing: the sheet strength takes differences of Γ only, and as much
/// air enters a region as leaves it. But a bubble's pressure makes just such a part grow for ever, 4σ/R in a unit of
/// time at rest, and the flux through a triangulated region is zero only up to the error of discretisation: sums over
/// Γ̄ u·n would soon measure nothing but c times that error. So the constants that make
/// Σ_t area_t (Γ̄_t^{pq} − (c_p − c_q))² least are subtracted; for one bubble, the area-weighted mean.
///
/// `sheet`: triangles of `mesh`; `positions` (L): indexed by vertex handle. One sparse solve with as many unknowns as
/// there are regions.
std::vector<double> circulation_without_region_constants(const lostopos::SurfaceMesh& mesh,
                                                         std::span<const SheetTriangle> sheet,
                                                         std::span<const lostopos::Vec3> positions);

}  // namespace foamsim
