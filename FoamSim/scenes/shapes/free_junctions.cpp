#include "FoamSim/scenes/shapes/free_junctions.h"

#include <array>
#include <numbers>

#include "LosTopos/shapes/film_polygons.h"

namespace foamsim {

using lostopos::FilmPolygons;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

// A quadrilateral in two triangles that share the diagonal a–c.
void add_quadrilateral(FilmPolygons& films, std::size_t a, std::size_t b, std::size_t c, std::size_t d, Labels labels) {
  films.films.push_back({{a, b, c}, labels});
  films.films.push_back({{a, c, d}, labels});
}

}  // namespace

SurfaceMesh free_triple_junction(long n) {
  const double z = std::numbers::sqrt3 / 2;
  const std::array<Vec3, 3> outer{Vec3(2, 0, 0), Vec3(-0.5, 0, -z), Vec3(-0.5, 0, z)};
  const Vec3 along(0, 1, 0);
  FilmPolygons films;
  films.corners = {{Vec3::Zero()}, {along}};
  for (const Vec3& foot : outer) {
    films.corners.push_back({foot});
    films.corners.push_back({foot + along});
  }
  // The normals, axis × outwards, turn from each film to the next.
  for (std::size_t k = 0; k < 3; ++k)
    add_quadrilateral(films, 0, 1, 3 + 2 * k, 2 + 2 * k, {Region(k), Region((k + 1) % 3)});
  return lostopos::triangulated(films, n);
}

SurfaceMesh free_quad_junction(long n) {
  const double a = 1 / std::numbers::sqrt2;
  struct Film {
    std::size_t i, j;
    Vec3 outer;
    Labels labels;
  };
  const auto labels = [](int p, int q) { return Labels{Region(p), Region(q)}; };
  const std::array<Film, 6> quadrilaterals{
      Film{1, 2, {0, 0, -2 * a}, labels(1, 0)}, Film{1, 3, {-1, -1, 0}, labels(0, 2)},
      Film{1, 4, {-1, 1, 0}, labels(2, 1)},     Film{2, 3, {1, -1, 0}, labels(3, 0)},
      Film{2, 4, {1, 1, 0}, labels(1, 3)},      Film{3, 4, {0, 0, 2 * a}, labels(3, 2)}};
  FilmPolygons films;
  films.corners = {{Vec3::Zero()}, {Vec3(-1, 0, -a)}, {Vec3(1, 0, -a)}, {Vec3(0, -1, a)}, {Vec3(0, 1, a)}};
  films.corners[0].position = 0.7 * films.corners[1].position;
  for (const Film& film : quadrilaterals) {
    films.corners.push_back({film.outer});
    add_quadrilateral(films, 0, film.i, films.corners.size() - 1, film.j, film.labels);
  }
  return lostopos::triangulated(films, n);
}

}  // namespace foamsim
