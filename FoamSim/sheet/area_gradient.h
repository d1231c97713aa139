#pragma once

#include <cstdint>
#include <span>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Area of the films (L²) with vertices at `positions`; the same sum as SurfaceGeometry's, which is of the mesh's own.
double film_area(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid,
                 std::span<const lostopos::Vec3> positions);

/// Adds `factor` times the gradient of the films' area with respect to every vertex, for vertices at `positions` (L, by
/// slot): exact for the triangles, Σ_t ½ n_t × (x_c − x_b) for corner a. `solid` by triangle slot: not zero for those
/// that are no film; may be empty. Same bits for any number of threads.
void add_area_gradient(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid,
                       std::span<const lostopos::Vec3> positions, double factor, std::span<lostopos::Vec3> gradient);

}  // namespace foamsim
