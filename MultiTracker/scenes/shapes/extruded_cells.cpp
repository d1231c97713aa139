#include "MultiTracker/scenes/shapes/extruded_cells.h"

#include <algorithm>
#include <map>
#include <utility>

namespace multitracker {

using lostopos::FilmPolygons;
using lostopos::Region;

namespace {

using Side = std::pair<std::size_t, std::size_t>;

std::map<Side, Region> regions_left_of(const PlaneCells& cells) {
  std::map<Side, Region> regions;
  for (const PlaneCells::Cell& cell : cells.cells)
    for (std::size_t i = 0; i < cell.corners.size(); ++i)
      regions[{cell.corners[i], cell.corners[(i + 1) % cell.corners.size()]}] = cell.region;
  return regions;
}

}  // namespace

FilmPolygons extruded(const PlaneCells& cells, double height, long layers) {
  FilmPolygons result;
  const std::size_t count = cells.corners.size();
  for (long layer = 0; layer <= layers; ++layer) {
    const double z = layer == layers ? height : height * static_cast<double>(layer) / static_cast<double>(layers);
    for (const Eigen::Vector2d& x : cells.corners) result.corners.push_back({{x.x(), x.y(), z}});
  }
  const auto regions = regions_left_of(cells);
  for (const auto& [side, inside] : regions) {
    const auto [a, b] = side;
    const auto other = regions.find({b, a});
    const Region outside = other == regions.end() ? lostopos::air : other->second;
    if (outside == inside || (other != regions.end() && b < a)) continue;  // no film, or made from its other side
    for (std::size_t low = 0; low < static_cast<std::size_t>(layers) * count; low += count)
      result.films.push_back({{low + a, low + b, low + count + b, low + count + a}, {inside, outside}});
  }
  for (const PlaneCells::Cell& cell : cells.cells) {
    std::vector<std::size_t> bottom(cell.corners.rbegin(), cell.corners.rend()), top = cell.corners;
    for (std::size_t& corner : top) corner += static_cast<std::size_t>(layers) * count;
    result.films.push_back({bottom, {cell.region, lostopos::air}});
    result.films.push_back({top, {cell.region, lostopos::air}});
  }
  return result;
}

}  // namespace multitracker
