#include "MultiTracker/scenes/shapes/film_boxes.h"

#include <array>
#include <cmath>
#include <numbers>

#include "LosTopos/shapes/indexed_surface.h"
#include "MultiTracker/scenes/shapes/extruded_cells.h"

namespace multitracker {

using lostopos::FilmPolygons;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

SurfaceMesh four_cells(const FourCellsOptions& options) {
  const double w = options.size.x(), h = options.size.y();
  PlaneCells cells;
  cells.corners = {{0, 0}, {w, 0}, {w, h}, {0, h}, {w / 2, (h - options.gap) / 2}};
  std::size_t upper = 4;
  if (options.gap > 0) {
    upper = 5;
    cells.corners.emplace_back(w / 2, (h + options.gap) / 2);
  }
  cells.cells = {{{2, 3, upper}, Region(1)}, {{0, 1, 4}, Region(2)}};
  if (options.gap > 0) {
    cells.cells.push_back({{3, 0, 4, upper}, Region(3)});
    cells.cells.push_back({{1, 2, upper, 4}, Region(4)});
  } else {
    cells.cells.push_back({{3, 0, 4}, Region(3)});
    cells.cells.push_back({{1, 2, 4}, Region(4)});
  }
  return triangulated(extruded(cells, options.size.z(), options.layers), options.subdivisions);
}

SurfaceMesh three_cells(long layers, long subdivisions) {
  PlaneCells cells;
  cells.corners = {{0.5, 0.5}, {0.5, 1}, {0, 0.25}, {1, 0.25}, {0, 1}, {0, 0}, {1, 0}, {1, 1}};
  cells.cells = {{{0, 1, 4, 2}, Region(1)}, {{0, 2, 5, 6, 3}, Region(2)}, {{0, 3, 7, 1}, Region(3)}};
  return triangulated(extruded(cells, 1, layers), subdivisions);
}

SurfaceMesh nested_tetrahedra(double size, long subdivisions) {
  const std::array<Vec3, 4> directions{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  // Face i lies opposite to corner i, counter-clockwise from outside.
  const std::array<std::array<std::size_t, 3>, 4> faces{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
  FilmPolygons films;
  for (double radius : {1.0, size})
    for (const Vec3& direction : directions) films.corners.push_back({radius / std::sqrt(3.0) * direction});
  const Region middle(5);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [a, b, c] = faces[i];
    films.films.push_back({{a, b, c}, {Region(i + 1), lostopos::air}});
    films.films.push_back({{a + 4, b + 4, c + 4}, {middle, Region(i + 1)}});
    // Face i's sides, each between it and the face that has the side the other way round.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = faces[i][k], to = faces[i][(k + 1) % 3], other = 6 - i - from - to;
      if (i < other) films.films.push_back({{from, from + 4, to + 4, to}, {Region(i + 1), Region(other + 1)}});
    }
  }
  return triangulated(films, subdivisions);
}

SurfaceMesh film_prism(const FilmPrismOptions& options) {
  const bool edge = options.middle == PrismMiddle::edge;
  FilmPolygons films;
  const auto add_triangle = [&films](double side, double z) {
    const double radius = side / std::sqrt(3.0);
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::numbers::pi * k / 3;
      films.corners.push_back({{radius * std::cos(angle), radius * std::sin(angle), z}});
    }
  };
  // Corners 0 to 2 of the top, 3 to 5 of the bottom, counter-clockwise from above; then the middle's.
  add_triangle(1, options.height / 2);
  add_triangle(1, -options.height / 2);
  if (edge) {
    for (double end : {0.5, -0.5}) films.corners.push_back({{0, 0, end * options.size}});
  } else {
    add_triangle(options.size, 0);
  }
  const Region above(1), below(2);
  const auto side = [](std::size_t k) { return Region(3 + k % 3); };
  films.films = {{{0, 1, 2}, {above, lostopos::air}}, {{5, 4, 3}, {below, lostopos::air}}};
  if (!edge) films.films.push_back({{6, 7, 8}, {below, above}});
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    films.films.push_back({{k, k + 3, next + 3, next}, {side(k), lostopos::air}});
    if (edge) {
      films.films.push_back({{k, next, 6}, {side(k), above}});
      films.films.push_back({{k + 3, 7, next + 3}, {side(k), below}});
      films.films.push_back({{k, 6, 7, k + 3}, {side(k), side(k + 2)}});
    } else {
      films.films.push_back({{k, next, next + 6, k + 6}, {side(k), above}});
      films.films.push_back({{k + 3, k + 6, next + 6, next + 3}, {side(k), below}});
      films.films.push_back({{k, k + 6, k + 3}, {side(k), side(k + 2)}});
    }
  }
  return triangulated(films, options.subdivisions);
}

SurfaceMesh open_tube(double radius, double half_length, long segments) {
  const double side = 2 * radius * std::sin(std::numbers::pi / static_cast<double>(segments));
  const long rows = 2 * std::max(1L, std::lround(half_length / side));
  SurfaceMesh mesh;
  for (long row = 0; row <= rows; ++row)
    for (long i = 0; i < segments; ++i) {
      const double turn = static_cast<double>(i) + (row % 2 == 0 ? 0 : 0.5);
      const double angle = 2 * std::numbers::pi * turn / static_cast<double>(segments);
      const double x = row == 0      ? -half_length
                       : row == rows ? half_length
                                     : half_length * (2 * static_cast<double>(row) / static_cast<double>(rows) - 1);
      mesh.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)});
    }
  const auto at = [segments](long row, long i) {
    return Vertex(static_cast<std::size_t>(row * segments + i % segments));
  };
  const lostopos::Labels labels{Region(1), lostopos::air};
  for (long row = 0; row < rows; ++row)
    for (long i = 0; i < segments; ++i) {
      const Vertex a = at(row, i), b = at(row, i + 1), c = at(row + 1, i), d = at(row + 1, i + 1);
      if (row % 2 == 0) {
        mesh.add_triangle(a, b, c, labels);
        mesh.add_triangle(b, d, c, labels);
      } else {
        mesh.add_triangle(a, d, c, labels);
        mesh.add_triangle(a, b, d, labels);
      }
    }
  return mesh;
}

}  // namespace multitracker
