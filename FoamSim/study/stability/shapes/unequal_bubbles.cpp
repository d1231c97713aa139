#include "FoamSim/study/stability/shapes/unequal_bubbles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "FoamSim/study/double_bubble_equilibrium.h"
#include "LosTopos/error.h"

namespace foamsim {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

namespace {

using Ring = std::vector<Vertex>;

class FilmsOfRevolution {
 public:
  FilmsOfRevolution(double rim_radius, double edge) : rim_radius_(rim_radius), edge_(edge) {
    rim_ = add_ring(0, rim_radius, std::max(6L, std::lround(2 * pi * rim_radius / edge)), 0);
  }

  // From the rim to the pole, which lies at x > 0 for direction 1, at x < 0 for −1. Labels are for normals along +x at
  // the pole.
  void add(const SphericalFilm& film, int direction, Labels labels) {
    const bool flat = std::isinf(film.radius);
    const double length = flat ? rim_radius_ : film.radius * film.polar_angle;
    const long rows = std::max(1L, std::lround(length / (edge_ * std::numbers::sqrt3 / 2)));
    auto x_at = [&](double s) {
      return flat ? 0.0 : direction * film.radius * (std::cos(film.polar_angle * (1 - s)) - std::cos(film.polar_angle));
    };
    auto distance_at = [&](double s) {
      return flat ? rim_radius_ * (1 - s) : film.radius * std::sin(film.polar_angle * (1 - s));
    };
    Ring outer = rim_;
    for (long row = 1; row < rows; ++row) {
      const double s = static_cast<double>(row) / static_cast<double>(rows);
      const long segments = std::max(5L, std::lround(2 * pi * distance_at(s) / edge_));
      const Ring inner = add_ring(x_at(s), distance_at(s), segments, row % 2 == 0 ? 0 : 0.5);
      add_strip(outer, inner, labels);
      outer = inner;
    }
    const Vertex pole = mesh_.add_vertex({x_at(1), 0, 0});
    for (std::size_t k = 0; k < outer.size(); ++k)
      mesh_.add_triangle(outer[k], outer[(k + 1) % outer.size()], pole, labels);
  }

  SurfaceMesh take() { return std::move(mesh_); }

 private:
  Ring add_ring(double x, double radius, long segments, double phase) {
    Ring ring;
    for (long k = 0; k < segments; ++k) {
      const double angle = 2 * pi * (static_cast<double>(k) + phase) / static_cast<double>(segments);
      ring.push_back(mesh_.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)}));
    }
    return ring;
  }

  // Goes around both rings at once, along the ring that is behind.
  void add_strip(const Ring& outer, const Ring& inner, Labels labels) {
    const std::size_t m = outer.size(), n = inner.size();
    std::size_t i = 0, j = 0;
    while (i < m || j < n) {
      if (j == n || (i < m && i * n <= j * m)) {
        mesh_.add_triangle(outer[i % m], outer[(i + 1) % m], inner[j % n], labels);
        ++i;
      } else {
        mesh_.add_triangle(outer[i % m], inner[(j + 1) % n], inner[j % n], labels);
        ++j;
      }
    }
  }

  double rim_radius_, edge_;
  SurfaceMesh mesh_;
  Ring rim_;
};

}  // namespace

SurfaceMesh unequal_double_bubble(double volume1, double volume2, double edge) {
  if (!(std::isfinite(edge) && edge > 0)) throw lostopos::InputError("the edge length has to be a finite length > 0");
  const DoubleBubbleEquilibrium exact = double_bubble_equilibrium(volume1, volume2);
  FilmsOfRevolution films(exact.rim_radius, edge);
  films.add(exact.outer[0], -1, {air, Region(1)});
  films.add(exact.outer[1], +1, {Region(2), air});
  films.add(exact.wall, volume1 <= volume2 ? +1 : -1, {Region(1), Region(2)});
  return films.take();
}

}  // namespace foamsim
