#pragma once

#include <cstddef>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// The parts of `repair_surface`. Each returns how many elements it has changed.
/// @{
/// Vertices at most `distance` (L) from one with a smaller number become that one. Triangles may then have a corner
/// twice: drop_collapsed_triangles has to follow.
std::size_t merge_vertices(SurfaceData& data, double distance);
std::size_t drop_collapsed_triangles(SurfaceData& data);
/// Triangles with their corners on a line.
std::size_t remove_flat_triangles(SurfaceData& data);
/// Triangles on the same three vertices, as far as their regions go together.
std::size_t merge_repeated_triangles(SurfaceData& data);
/// Turns triangles against their film, and films against their neighbours at junctions.
std::size_t orient_films(SurfaceData& data);
/// Turns closed films that no other film joins, where lines through the surface show them inside out.
std::size_t orient_bubbles(SurfaceData& data);
/// @}

}  // namespace lostopos
