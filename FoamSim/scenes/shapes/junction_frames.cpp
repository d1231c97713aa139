#include "FoamSim/scenes/shapes/junction_frames.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "LosTopos/shapes/film_polygons.h"

namespace foamsim {

using lostopos::FilmPolygons;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

SurfaceMesh triple_junction_frame(long n, double displacement) {
  FilmPolygons films;
  films.corners = {{Vec3(0, 0, -0.5)}, {Vec3(0, 0, 0.5)}};
  for (int k = 0; k < 3; ++k)
    for (double z : {-0.5, 0.5}) films.corners.push_back({Vec3(std::cos(2 * pi * k / 3), std::sin(2 * pi * k / 3), z)});
  for (std::size_t k = 0; k < 3; ++k) {
    // Counter-clockwise as seen from the film's clockwise side: the region behind is the next one around the axis.
    const std::size_t low = 2 + 2 * k;
    films.films.push_back({{0, low, low + 1, 1}, {Region(1 + (k + 1) % 3), Region(1 + k)}});
  }
  SurfaceMesh mesh = lostopos::triangulated(films, n);
  for (Vertex v : mesh.vertices()) {
    const Vec3 x = mesh.position(v);
    const double off_axis = std::hypot(x.x(), x.y());
    mesh.set_position(v, x + Vec3(displacement * (1 - off_axis) * std::cos(pi * x.z()), 0, 0));
  }
  return mesh;
}

SurfaceMesh quad_junction_frame(long n, double displacement) {
  FilmPolygons films;
  const double s = 1 / std::numbers::sqrt3;
  films.corners = {
      {Vec3(displacement, 0, 0)}, {Vec3(s, s, s)}, {Vec3(s, -s, -s)}, {Vec3(-s, s, -s)}, {Vec3(-s, -s, s)}};
  for (std::size_t a = 1; a <= 4; ++a)
    for (std::size_t b = a + 1; b <= 4; ++b) {
      std::array<std::size_t, 2> others{};
      std::size_t found = 0;
      for (std::size_t c = 1; c <= 4; ++c)
        if (c != a && c != b) others[found++] = c;
      // The region on the side of a corner is the one opposite to the other corner.
      const auto x = [&films](std::size_t i) { return films.corners[i].position; };
      const Vec3 normal = x(a).cross(x(b));
      const bool first_in_front = normal.dot(x(others[0])) > 0;
      const Region front(first_in_front ? others[1] : others[0]), behind(first_in_front ? others[0] : others[1]);
      films.films.push_back({{0, a, b}, Labels{behind, front}});
    }
  return lostopos::triangulated(films, n);
}

}  // namespace foamsim
