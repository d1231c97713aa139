#pragma once

#include <Eigen/Core>
#include <vector>

#include "LosTopos/shapes/film_polygons.h"

namespace multitracker {

/// A part of the plane divided into cells.
struct PlaneCells {
  struct Cell {
    std::vector<std::size_t> corners;  ///< counter-clockwise; all corners on the cell's boundary, neighbours' too
    lostopos::Region region;
  };
  std::vector<Eigen::Vector2d> corners;
  std::vector<Cell> cells;
};

/// The prisms over the cells from z = 0 to `height`, in the air, with their sides in `layers` rows of rectangles. There
/// is no film between cells of the same region.
lostopos::FilmPolygons extruded(const PlaneCells& cells, double height, long layers);

}  // namespace multitracker
