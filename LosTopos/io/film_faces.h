#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Turns triangles so that the lower of their two regions lies behind the right-hand normal: every film then has one
/// orientation. Arrays stay: their values must not depend on the order of corners.
void put_lower_regions_behind(SurfaceData& data);

/// The film that each triangle is part of, numbered from 0. A film is what hangs together between the same two regions
/// over edges that just two triangles share; films are in the order of their regions, those between the same two in
/// that of their first triangles.
std::vector<std::uint32_t> film_numbers(const SurfaceData& data);

/// Edges that more than two triangles share, the Plateau borders, as pairs of vertices that ascend.
std::vector<std::array<std::uint32_t, 2>> border_edges(const SurfaceData& data);

/// The surface as ParaView is given it: films oriented, `lines` the Plateau borders.
SurfaceData film_picture(SurfaceData data);

}  // namespace lostopos
