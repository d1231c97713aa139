#include "FoamSim/scenes/shapes/double_bubble.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "Base/error.h"

namespace foamsim {

using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

using Ring = std::vector<Vertex>;

Ring add_ring(SurfaceMesh& mesh, long n, double x, double radius) {
  Ring ring;
  for (long k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    ring.push_back(mesh.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return ring;
}

// A fan whose right-hand normals point along +x; `labels` (behind, in front) is for that direction.
void add_fan(SurfaceMesh& mesh, Vertex centre, const Ring& ring, Labels labels) {
  for (std::size_t k = 0; k < ring.size(); ++k) mesh.add_triangle(centre, ring[k], ring[(k + 1) % ring.size()], labels);
}

// A belt between two rings, `left` at the smaller x, normals away from the axis.
void add_belt(SurfaceMesh& mesh, const Ring& left, const Ring& right, Labels labels) {
  for (std::size_t k = 0; k < left.size(); ++k) {
    const std::size_t next = (k + 1) % left.size();
    mesh.add_triangle(left[k], right[next], right[k], labels);
    mesh.add_triangle(left[k], left[next], right[next], labels);
  }
}

// The cap of one sphere from its pole to the junction ring; side −1: left, +1: right.
void add_cap(SurfaceMesh& mesh, long n, long overlap, int side, const Ring& junction, Region inside) {
  const double step = std::numbers::pi / static_cast<double>(n);
  const double centre = side * std::cos(step * static_cast<double>(overlap));
  const Vertex pole = mesh.add_vertex({centre + side, 0, 0});
  const Labels outwards{inside, lostopos::air};
  Ring outer;
  for (long ring_index = 1; ring_index <= n - overlap; ++ring_index) {
    const double polar = step * static_cast<double>(ring_index);
    const Ring ring =
        ring_index == n - overlap ? junction : add_ring(mesh, n, centre + side * std::cos(polar), std::sin(polar));
    if (ring_index == 1)
      add_fan(mesh, pole, ring, side > 0 ? outwards : outwards.flipped());
    else if (side > 0)
      add_belt(mesh, ring, outer, outwards);
    else
      add_belt(mesh, outer, ring, outwards);
    outer = ring;
  }
}

}  // namespace

SurfaceMesh double_bubble(long n) {
  if (n < 8) throw base::InputError("a double bubble needs n >= 8 subdivisions; n = " + std::to_string(n));
  const long overlap = n / 8;
  SurfaceMesh mesh;
  mesh.reserve(static_cast<std::size_t>(2 * n * (n - overlap) + 3), static_cast<std::size_t>(4 * n * (n - overlap)));
  const double rim = std::sin(std::numbers::pi * static_cast<double>(overlap) / static_cast<double>(n));
  const Ring junction = add_ring(mesh, n, 0, rim);
  add_cap(mesh, n, overlap, -1, junction, Region(1));
  add_cap(mesh, n, overlap, +1, junction, Region(2));
  // Normals along +x lead out of the left bubble into the right one.
  add_fan(mesh, mesh.add_vertex({0, 0, 0}), junction, {Region(1), Region(2)});
  return mesh;
}

}  // namespace foamsim
