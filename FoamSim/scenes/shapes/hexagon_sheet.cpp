#include "FoamSim/scenes/shapes/hexagon_sheet.h"

#include <numbers>
#include <vector>

#include "FoamSim/scenes/shapes/held.h"
#include "LosTopos/shapes/film_polygons.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

lostopos::SurfaceMesh hexagon_sheet(long n) {
  const double y = 0.2, z = std::numbers::sqrt3 / 2;
  lostopos::FilmPolygons films;
  films.corners = {{Vec3(0, y, 0)},  {Vec3(1, y, 0)},     {Vec3(0.5, y, z)}, {Vec3(-0.5, y, z)},
                   {Vec3(-1, y, 0)}, {Vec3(-0.5, y, -z)}, {Vec3(0.5, y, -z)}};
  for (std::size_t k = 1; k <= 6; ++k) films.films.push_back({{0, k % 6 + 1, k}, {lostopos::Region(1), lostopos::air}});
  lostopos::SurfaceMesh mesh = lostopos::triangulated(films, n);
  std::vector<char> on_border(mesh.vertex_slots(), 0);
  for (lostopos::Edge e : mesh.edges())
    if (mesh.triangles(e).size() == 1)
      for (Vertex v : mesh.vertices(e)) on_border[v.index()] = 1;
  std::vector<Vertex> border;
  for (Vertex v : mesh.vertices()) {
    if (!on_border[v.index()]) continue;
    border.push_back(v);
    const Vec3 x = mesh.position(v);
    mesh.set_position(v, x - Vec3(0, 0.6 * x.z() * x.z(), 0));
  }
  mark_held(mesh, border);
  return mesh;
}

}  // namespace foamsim
