#include "LosTopos/shapes/voronoi_foam.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <voro++/voro++.hh>

#include "LosTopos/error.h"
#include "LosTopos/shapes/film_polygons.h"

namespace lostopos {
namespace {

// Voro++ numbers the walls of the box -1 (x = 0), -2 (x = 1), -3 (y = 0) and so on.
constexpr int first_wall = -6, last_wall = -1;

struct Face {
  int neighbour;  // a cell, from 0, or a wall
  std::vector<std::size_t> corners;
};

struct Cell {
  Vec3 site, centroid;
  std::vector<Vec3> corners;
  std::vector<Face> faces;
};

// What is meant by the same corner in neighbouring cells: it lies between the same cells and walls. Points in general
// position have four of them around each corner, and no other corner lies between the same four.
using CornerName = std::vector<int>;

std::vector<Vec3> random_points(long count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11) + 0.5, -53); };
  std::vector<Vec3> points(static_cast<std::size_t>(count));
  for (Vec3& point : points) {
    for (double& x : point) x = coordinate();
  }
  return points;
}

Cell read_cell(voro::voronoicell_neighbor& source, const Vec3& site) {
  Cell cell{site, site, {}, {}};
  Vec3 offset;
  source.centroid(offset.x(), offset.y(), offset.z());
  cell.centroid += offset;
  std::vector<double> coordinates;
  source.vertices(site.x(), site.y(), site.z(), coordinates);
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    cell.corners.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  std::vector<int> neighbours, corners;
  source.neighbors(neighbours);
  source.face_vertices(corners);  // for each face: the number of its corners, then these
  auto next = corners.begin();
  for (int neighbour : neighbours) {
    const int count = *next++;
    cell.faces.push_back({neighbour, {next, next + count}});
    next += count;
  }
  return cell;
}

std::vector<Cell> voronoi_cells(const std::vector<Vec3>& points) {
  // Voro++ is fastest with about five points a block.
  const int blocks = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(points.size()) / 5)));
  voro::container box(0, 1, 0, 1, 0, 1, blocks, blocks, blocks, false, false, false, 8);
  for (std::size_t i = 0; i < points.size(); ++i)
    box.put(static_cast<int>(i), points[i].x(), points[i].y(), points[i].z());
  std::vector<Cell> cells(points.size());
  voro::c_loop_all loop(box);
  voro::voronoicell_neighbor cell;
  if (!loop.start()) return cells;
  do {
    const auto i = static_cast<std::size_t>(loop.pid());
    if (box.compute_cell(cell, loop)) cells[i] = read_cell(cell, points[i]);
  } while (loop.inc());
  return cells;
}

std::vector<CornerName> corner_names(const Cell& cell, int index) {
  std::vector<CornerName> names(cell.corners.size(), CornerName{index});
  for (const Face& face : cell.faces) {
    for (std::size_t corner : face.corners) names[corner].push_back(face.neighbour);
  }
  for (CornerName& name : names) std::sort(name.begin(), name.end());
  return names;
}

FilmPolygons::Corner corner_at(const Vec3& position, const CornerName& name) {
  FilmPolygons::Corner corner{position, {}};
  for (int wall = first_wall; wall <= last_wall; ++wall) {
    if (!std::binary_search(name.begin(), name.end(), wall)) continue;
    const int number = -1 - wall;
    corner.position[number / 2] = number % 2;  // on the wall to the bit
    corner.fixed[static_cast<std::size_t>(number / 2)] = true;
  }
  return corner;
}

// The films between the cells and around them, each from the one of its two cells that has the lower number.
class FilmBuilder {
 public:
  void add(const Cell& cell, int index) {
    const std::vector<CornerName> names = corner_names(cell, index);
    for (const Face& face : cell.faces) {
      std::vector<std::size_t> corners;
      for (std::size_t corner : face.corners) corners.push_back(find_or_add(names[corner], cell.corners[corner]));
      if (face.neighbour >= 0 && face.neighbour < index)
        compare(std::move(corners), face.neighbour, index);
      else
        add_film(std::move(corners), cell.site, index, face.neighbour);
    }
  }

  FilmPolygons take() { return std::move(foam_); }

 private:
  std::size_t find_or_add(const CornerName& name, const Vec3& position) {
    const auto [it, added] = numbers_.try_emplace(name, foam_.corners.size());
    if (added) foam_.corners.push_back(corner_at(position, name));
    return it->second;
  }

  void add_film(std::vector<std::size_t> corners, const Vec3& site, int index, int neighbour) {
    Vec3 normal = Vec3::Zero();
    auto arm = [&](std::size_t i) { return Vec3(foam_.corners[corners[i]].position - site); };
    for (std::size_t i = 0; i < corners.size(); ++i) normal += arm(i).cross(arm((i + 1) % corners.size()));
    if (normal.dot(arm(0)) < 0) std::reverse(corners.begin(), corners.end());
    if (neighbour >= 0) film_of_[{index, neighbour}] = foam_.films.size();
    const auto region = [](int cell) { return Region(static_cast<std::size_t>(cell) + 1); };
    foam_.films.push_back({std::move(corners), {region(index), neighbour < 0 ? air : region(neighbour)}});
  }

  void compare(std::vector<std::size_t> corners, int lower, int upper) const {
    const auto found = film_of_.find({lower, upper});
    std::vector<std::size_t> other;
    if (found != film_of_.end()) other = foam_.films[found->second].corners;
    std::sort(corners.begin(), corners.end());
    std::sort(other.begin(), other.end());
    if (corners != other)
      throw MeshError("Voronoi cells " + std::to_string(lower + 1) + " and " + std::to_string(upper + 1) +
                      " do not agree on the film between them: five points lie on one sphere; another seed helps");
  }

  FilmPolygons foam_;
  std::map<CornerName, std::size_t> numbers_;
  std::map<std::pair<int, int>, std::size_t> film_of_;
};

void require_usable(const VoronoiFoamOptions& options) {
  constexpr long most_cells = 1'000'000;
  if (options.cells < 1 || options.cells > most_cells)
    throw base::InputError("a Voronoi foam of " + std::to_string(options.cells) + " cells; it needs 1 to " +
                           std::to_string(most_cells));
  if (options.relaxations < 0 || options.subdivisions < 0 || !(options.shortest_side >= 0) ||
      options.shortest_side > 0.5)
    throw base::InputError(
        "a Voronoi foam needs relaxations >= 0, subdivisions >= 0 and a shortest side between 0 and 0.5");
}

}  // namespace

SurfaceMesh voronoi_foam(const VoronoiFoamOptions& options) {
  require_usable(options);
  std::vector<Vec3> points = random_points(options.cells, options.seed);
  std::vector<Cell> cells = voronoi_cells(points);
  for (int i = 0; i < options.relaxations; ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = cells[k].centroid;
    cells = voronoi_cells(points);
  }
  FilmBuilder builder;
  for (std::size_t k = 0; k < cells.size(); ++k) builder.add(cells[k], static_cast<int>(k));
  const double size = 1 / std::cbrt(static_cast<double>(options.cells));
  return triangulated(without_short_sides(builder.take(), options.shortest_side * size), options.subdivisions);
}

}  // namespace lostopos
