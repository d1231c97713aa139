#pragma once

#include <string>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// The lengths that a surface may have, in its own unit: coordinates are at most `largest_length` in magnitude, and
/// edges 0 or at least `smallest_length` long. What is computed of a surface has up to seven factors of length (the
/// product of two volumes over an edge is five, a squared volume six) or one over as many (1 / length² of squared
/// areas): with forty decimal powers either way these stay between 1e-280 and 1e280, finite and normal doubles.
inline constexpr double smallest_length = 1e-40;
inline constexpr double largest_length = 1e40;

/// What is wrong with a surface's lengths, in words; empty when nothing is.
/// @{
std::string position_problem(const Vec3& position);
std::string edge_problem(const Vec3& from, const Vec3& to);
std::string resolution_problem(double resolution);
/// @}

/// Throws base::InputError, with the element, when a position or an edge of the mesh is out of range.
void require_lengths_in_range(const SurfaceMesh& mesh);

}  // namespace lostopos
