#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "FoamSim/sheet/region_pair.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A connected piece of film between two regions.
struct Film {
  RegionPair regions;
  double area = 0;                         ///< L²
  std::vector<std::size_t> borders;        ///< the Plateau borders along its rim, ascending
  std::vector<lostopos::Vertex> vertices;  ///< the Plateau vertices at its rim, ascending
};

/// A line along which three films or more meet, from one Plateau vertex, or end of the films, to the next.
struct PlateauBorder {
  double length = 0;   ///< L
  bool closed = true;  ///< it has no end, as that of a double bubble
};

/// What a foam is made of, with the mesh's triangles and edges put together.
struct FilmNetwork {
  std::vector<Film> films;                 ///< in the order of their first triangles
  std::vector<PlateauBorder> borders;      ///< in the order of their first edges
  std::vector<lostopos::Vertex> vertices;  ///< Plateau vertices, where three borders or more meet; ascending
};

/// Films are pieces of triangles of one pair of regions that are connected through edges of exactly two triangles.
/// `solid` by triangle slot: not zero for those that are no film, at which films end; may be empty.
FilmNetwork film_network(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid = {});

}  // namespace foamsim
