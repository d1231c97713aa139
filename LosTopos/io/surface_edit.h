#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Stands for the new number of a vertex that goes.
inline constexpr std::uint32_t dropped_vertex = Vertex::invalid_index;

/// Gives the vertices new numbers, 0 to n − 1, and triangles, arrays and held vertices with them: `numbers[v]` is that
/// of v, or `dropped_vertex`, which no triangle may use. Where several get the same number, position and values of the
/// first stay; the first ones' numbers have to rise.
void renumber_vertices(SurfaceData& data, const std::vector<std::uint32_t>& numbers);

/// Puts `triangles` in the place of all there are; each has the labels and the array values of the one that was
/// `parents[i]`. Lines go.
void replace_triangles(SurfaceData& data, std::vector<std::array<std::uint32_t, 3>> triangles,
                       const std::vector<std::size_t>& parents);

}  // namespace lostopos
