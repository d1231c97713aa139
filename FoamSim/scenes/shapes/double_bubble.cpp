#include "FoamSim/scenes/shapes/double_bubble.h"

#include "Base/error.h"
#include "FoamSim/scenes/shapes/revolution.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;

SurfaceMesh double_bubble(long n, long m) {
  if (n < 8) throw base::InputError("a double bubble needs n >= 8 subdivisions; n = " + std::to_string(n));
  if (m != 0 && m < 3) throw base::InputError("a double bubble needs m >= 3 segments; m = " + std::to_string(m));
  const long segments = m == 0 ? n : m, overlap = n / 8;
  SurfaceMesh mesh;
  mesh.reserve(static_cast<std::size_t>(2 * segments * (n - overlap) + 3),
               static_cast<std::size_t>(4 * segments * (n - overlap)));
  const CapShape left{.rings = n, .overlap = overlap, .side = -1}, right{.rings = n, .overlap = overlap, .side = 1};
  const Ring junction = add_ring(mesh, segments, 0, circle_radius(left));
  add_cap(mesh, left, junction, Region(1));
  add_cap(mesh, right, junction, Region(2));
  // Normals along +x lead out of the left bubble into the right one.
  add_fan(mesh, add_point(mesh, 0), junction, {Region(1), Region(2)});
  return mesh;
}

}  // namespace foamsim
