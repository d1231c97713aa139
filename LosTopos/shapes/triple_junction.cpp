#include "LosTopos/shapes/triple_junction.h"

#include <cmath>
#include <numbers>

namespace lostopos {

TripleJunction triple_junction(const std::array<double, 3>& degrees, int stretched, double stretch) {
  constexpr int along = 7, rows = 4;
  TripleJunction junction;
  for (int i = 0; i < along; ++i)
    junction.border.push_back(junction.mesh.add_vertex({static_cast<double>(i - 3), 0, 0}));
  double angle = 0;
  for (int film = 0; film < 3; ++film) {
    // A turn about +x from film i − 1 crosses region i and then film i.
    angle += degrees[static_cast<std::size_t>(film)] * std::numbers::pi / 180;
    const Vec3 out(0, std::cos(angle), std::sin(angle));
    junction.direction[static_cast<std::size_t>(film)] = out;
    const Labels turn{Region(static_cast<std::size_t>(film)), Region(static_cast<std::size_t>((film + 1) % 3))};
    std::vector<Vertex> inner = junction.border;
    for (int row = 1; row <= rows; ++row) {
      const double distance = row * (film == stretched ? stretch : 1.0);
      std::vector<Vertex> outer;
      outer.reserve(static_cast<std::size_t>(along));
      for (int i = 0; i < along; ++i)
        outer.push_back(junction.mesh.add_vertex(Vec3(static_cast<double>(i - 3), 0, 0) + distance * out));
      for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
        // (x, out, x × out): the right-hand normal points on along the turn.
        junction.mesh.add_triangle(inner[i], inner[i + 1], outer[i + 1], turn);
        junction.mesh.add_triangle(inner[i], outer[i + 1], outer[i], turn);
      }
      inner = outer;
    }
  }
  return junction;
}

}  // namespace lostopos
