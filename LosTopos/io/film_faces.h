#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Turns triangles so that the lower of their two regions lies behind the right-hand normal: every film then has one
/// orientation. Arrays stay: their values must not depend on the order of corners.
void put_lower_regions_behind(SurfaceData& data);

/// The film that each triangle is part of, numbered from 0. A film is what hangs together between the same two regions
/// over edges that just two triangles share; films are in the order of their regions, those between the same two in
/// that of their first triangles. `solid` by triangle: not zero for those that are no film; they hang together with
/// each other only. May be empty.
std::vector<std::uint32_t> film_numbers(const SurfaceData& data, std::span<const std::uint8_t> solid = {});

/// Edges that more than two triangles share, the Plateau borders, as pairs of vertices that ascend.
std::vector<std::array<std::uint32_t, 2>> border_edges(const SurfaceData& data);

/// Edges of one triangle alone, where a film ends, as such pairs.
std::vector<std::array<std::uint32_t, 2>> free_edges(const SurfaceData& data);

/// By triangle: 1 where the array "solid" is not 0, see docs/output.md.
std::vector<std::uint8_t> solid_triangles(const SurfaceData& data);

/// The surface as ParaView is given it: films oriented, `lines` the Plateau borders.
SurfaceData film_picture(SurfaceData data);

}  // namespace lostopos
