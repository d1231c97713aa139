#pragma once

#include <cstddef>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A flat, or nearly flat, film between two regions: its corners in order, counter-clockwise as seen from labels.q.
struct FilmPolygon {
  std::vector<std::size_t> corners;
  Labels labels;
};

/// A foam of polygonal films that have corners in common where they meet.
struct FilmPolygons {
  struct Corner {
    Vec3 position;
    /// Index of the coordinate (0, 1, 2) is true where it may not change, as on a wall.
    std::array<bool, 3> fixed = {};
  };
  std::vector<Corner> corners;
  std::vector<FilmPolygon> films;
};

/// Contracts sides shorter than `shortest` (L), shortest first, to their middle or to the end that is fixed; a film
/// with fewer than three corners left vanishes, and its neighbours meet instead. Sides whose contraction would make a
/// film meet itself, or meet another at all of its corners, stay.
FilmPolygons without_short_sides(FilmPolygons foam, double shortest);

/// Triangles from every film's centre of area to its sides (a triangular film is one triangle), each then divided into
/// four `subdivisions` times. Corners that no film uses are left out. Throws MeshError as SurfaceMesh::add_triangle.
SurfaceMesh triangulated(const FilmPolygons& foam, long subdivisions);

}  // namespace lostopos
