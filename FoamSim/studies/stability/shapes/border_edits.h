#pragma once

#include <cstdint>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The same surface with every junction edge divided into `parts` ≥ 1 equal ones, and the triangles at it into fans:
/// the films' triangles at the border become `parts` times as stretched, and no point of the surface moves.
lostopos::SurfaceMesh with_divided_borders(const lostopos::SurfaceMesh& mesh, long parts);

/// Moves vertices of films next to every second junction edge towards its middle, to the distance `height` (L): slivers
/// at the border. The poles of fans (more than eight triangles) stay. Returns how many slivers were made.
std::size_t press_slivers(lostopos::SurfaceMesh& mesh, double height);

/// Adds to every coordinate of every vertex a random number from [−amplitude, amplitude) (L).
void add_noise(lostopos::SurfaceMesh& mesh, double amplitude, std::uint64_t seed);

/// Multiplies all positions by `scale`, then adds `offset` (L).
void transform(lostopos::SurfaceMesh& mesh, double scale, const lostopos::Vec3& offset);

/// Largest ratio of the longest side to the height above it, over the triangles at junction edges.
double most_stretched_at_borders(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
