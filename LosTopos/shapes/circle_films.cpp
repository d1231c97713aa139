#include "LosTopos/shapes/circle_films.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "Base/error.h"

namespace lostopos {
namespace {

using std::numbers::pi;
using Ring = std::vector<Vertex>;

Ring add_ring(SurfaceMesh& mesh, double x, double radius, long segments, double phase) {
  Ring ring;
  for (long k = 0; k < segments; ++k) {
    const double angle = 2 * pi * (static_cast<double>(k) + phase) / static_cast<double>(segments);
    ring.push_back(mesh.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return ring;
}

// Triangles between two rings, the shorter diagonal first; right-hand normals along +x for an inner ring that is
// smaller, in the plane's case.
void stitch(SurfaceMesh& mesh, const Ring& outer, const Ring& inner, Labels labels) {
  std::size_t i = 0, j = 0;
  auto at = [](const Ring& ring, std::size_t k) { return ring[k % ring.size()]; };
  auto distance = [&mesh](Vertex a, Vertex b) { return (mesh.position(a) - mesh.position(b)).norm(); };
  while (i < outer.size() || j < inner.size()) {
    const bool advance_outer = j == inner.size() || (i < outer.size() && distance(at(outer, i + 1), at(inner, j)) <=
                                                                             distance(at(outer, i), at(inner, j + 1)));
    if (advance_outer) {
      mesh.add_triangle(at(outer, i), at(outer, i + 1), at(inner, j), labels);
      ++i;
    } else {
      mesh.add_triangle(at(outer, i), at(inner, j + 1), at(inner, j), labels);
      ++j;
    }
  }
}

// A film from the rim (s = 0) to its pole (s = 1): its length, and x and the distance from the axis on the way.
struct Profile {
  double length;
  std::function<std::array<double, 2>(double)> at;
};

Profile profile_of(double rim_radius, double polar_angle) {
  if (polar_angle == 0) return {rim_radius, [rim_radius](double s) { return std::array{0.0, rim_radius * (1 - s)}; }};
  const double rim_angle = std::abs(polar_angle), radius = rim_radius / std::sin(rim_angle);
  const double side = polar_angle > 0 ? 1 : -1;
  return {radius * rim_angle, [=](double s) {
            const double angle = rim_angle * (1 - s);
            // The difference of the cosines of `angle` and `rim_angle`, good for flat caps too.
            const double rise = 2 * std::sin((rim_angle + angle) / 2) * std::sin((rim_angle - angle) / 2);
            return std::array{side * radius * rise, radius * std::sin(angle)};
          }};
}

void add_film(SurfaceMesh& mesh, const Ring& rim, const Profile& profile, double edge, Labels labels) {
  const long rows = std::max(1L, std::lround(profile.length / (edge * std::numbers::sqrt3 / 2)));
  Ring outer = rim;
  for (long row = 1; row < rows; ++row) {
    const auto [x, distance] = profile.at(static_cast<double>(row) / static_cast<double>(rows));
    const long segments = std::max(5L, std::lround(2 * pi * distance / edge));
    const Ring inner = add_ring(mesh, x, distance, segments, row % 2 == 0 ? 0 : 0.5);
    stitch(mesh, outer, inner, labels);
    outer = inner;
  }
  const Vertex pole = mesh.add_vertex({profile.at(1)[0], 0, 0});
  for (std::size_t k = 0; k < outer.size(); ++k)
    mesh.add_triangle(outer[k], outer[(k + 1) % outer.size()], pole, labels);
}

}  // namespace

SurfaceMesh films_on_circle(double rim_radius, std::span<const CircleFilm> films, long segments) {
  if (!(std::isfinite(rim_radius) && rim_radius > 0))
    throw base::InputError("the circle's radius has to be finite and > 0");
  if (segments < 6)
    throw base::InputError("a circle needs 6 segments or more; " + std::to_string(segments) + " are too few");
  for (const CircleFilm& film : films)
    if (!(std::abs(film.polar_angle) < pi))
      throw base::InputError("a polar angle has to lie between -180 and 180 degrees");
  SurfaceMesh mesh;
  const double edge = 2 * pi * rim_radius / static_cast<double>(segments);
  const Ring rim = add_ring(mesh, 0, rim_radius, segments, 0);
  for (const CircleFilm& film : films) add_film(mesh, rim, profile_of(rim_radius, film.polar_angle), edge, film.labels);
  return mesh;
}

}  // namespace lostopos
