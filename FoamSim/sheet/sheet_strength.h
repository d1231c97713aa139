#pragma once

#include <array>
#include <span>
#include <vector>

#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"

namespace foamsim {

/// A triangle with the circulation at its corners, for its own label order: all that velocity and energy need of Γ.
struct SheetTriangle {
  lostopos::Triangle triangle;
  std::array<lostopos::Vertex, 3> vertices;
  std::array<double, 3> circulation;  ///< Γ^{pq} at the corners, L²/T

  double mean_circulation() const { return (circulation[0] + circulation[1] + circulation[2]) / 3; }
};

/// The living triangles in slot order with their circulation; `sheet` is overwritten. Triangles of a solid (`solid`
/// by triangle slot, not zero for these; may be empty) carry no vorticity and are left out.
void gather_sheet(const lostopos::SurfaceMesh& mesh, const CirculationField& circulation,
                  std::vector<SheetTriangle>& sheet, std::span<const std::uint8_t> solid = {});

/// Sheet strength times area of a triangle with corners x (docs/method.md "The step", 2; Da et al. 2015):
/// γ = −[(x_b − x_a) Γ_c + (x_c − x_b) Γ_a + (x_a − x_c) Γ_b], L³/T.
lostopos::Vec3 sheet_strength(const std::array<lostopos::Vec3, 3>& x, const std::array<double, 3>& circulation);

/// One point vortex a triangle, at its barycentre, for vertices at `positions` (indexed by vertex handle).
void fill_vortex_sources(std::span<const SheetTriangle> sheet, std::span<const lostopos::Vec3> positions,
                         VortexSources& sources);

}  // namespace foamsim
