#include "FoamSim/scenes/shapes/held_bubbles.h"

#include <string>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/edge_distance.h"
#include "FoamSim/scenes/shapes/held.h"
#include "FoamSim/scenes/shapes/revolution.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/scenes/shapes/wands.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

void require_sizes(const char* what, long n, long m) {
  if (n < 6 || m < 3)
    throw base::InputError(std::string(what) + " needs n >= 6 rings and m >= 3 segments; n = " + std::to_string(n) +
                           ", m = " + std::to_string(m));
}

}  // namespace

SurfaceMesh held_ellipsoid(long n) {
  if (n < 2) throw base::InputError("a held ellipsoid needs n >= 2 subdivisions; n = " + std::to_string(n));
  SurfaceMesh mesh = ellipsoid(n, {0.6, 1, 1});
  Vertex pole = *mesh.vertices().begin();
  for (Vertex v : mesh.vertices())
    if (mesh.position(v).x() < mesh.position(pole).x()) pole = v;
  mark_held(mesh, at_edge_distance(mesh, pole, 2));
  return mesh;
}

SurfaceMesh peanut(long n, long m) {
  require_sizes("a peanut", n, m);
  SurfaceMesh mesh;
  const CapShape left{.rings = n, .overlap = n / 3, .side = -1};
  const CapShape right{.rings = n, .overlap = n / 3, .side = 1, .taper = 0.001};
  const Ring waist = add_ring(mesh, m, 0, circle_radius(left));
  add_cap(mesh, left, waist, Region(1));
  add_cap(mesh, right, waist, Region(1));
  mark_held(mesh, waist);
  return mesh;
}

SurfaceMesh carousel(long n, long m) {
  require_sizes("a carousel", n, m);
  SurfaceMesh mesh;
  Ring held;
  const CapShape left{.rings = n, .overlap = n / 3, .side = -1, .radius = 4};
  const CapShape right{.rings = n, .overlap = n / 3, .side = 1, .radius = 4};
  const Ring junction = add_ring(mesh, m, 0, circle_radius(left));
  const auto ring = static_cast<std::size_t>(n / 6);  // counted from 1 it is n/6 + 1
  for (const auto& [cap, inside] : {std::pair{left, Region(1)}, std::pair{right, Region(2)}}) {
    const Ring wire = add_cap(mesh, cap, junction, inside).at(ring);
    held.insert(held.end(), wire.begin(), wire.end());
  }
  add_fan(mesh, add_point(mesh, 0), junction, {Region(1), Region(2)});
  const Ring straw = add_straw(mesh, {.segments = n / 2, .mouth = -6, .axis = Axis::y, .inside = Region(3)});
  held.insert(held.end(), straw.begin(), straw.end());
  mark_held(mesh, held);
  return mesh;
}

}  // namespace foamsim
