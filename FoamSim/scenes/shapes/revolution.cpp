#include "FoamSim/scenes/shapes/revolution.h"

#include <cmath>
#include <numbers>

namespace foamsim {

using lostopos::Labels;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// A half turn about x = y takes the x axis to the y axis.
Vec3 turned(const Vec3& x, Axis axis) {
  return axis == Axis::x ? x : Vec3(x.y(), x.x(), -x.z());
}

}  // namespace

Vertex add_point(SurfaceMesh& mesh, double along, Axis axis) {
  return mesh.add_vertex(turned({along, 0, 0}, axis));
}

Ring add_ring(SurfaceMesh& mesh, long count, double along, double radius, Axis axis) {
  Ring ring;
  for (long k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    ring.push_back(mesh.add_vertex(turned({along, radius * std::cos(angle), radius * std::sin(angle)}, axis)));
  }
  return ring;
}

void add_fan(SurfaceMesh& mesh, Vertex centre, const Ring& ring, Labels labels) {
  for (std::size_t k = 0; k < ring.size(); ++k) mesh.add_triangle(centre, ring[k], ring[(k + 1) % ring.size()], labels);
}

void add_belt(SurfaceMesh& mesh, const Ring& low, const Ring& high, Labels labels) {
  for (std::size_t k = 0; k < low.size(); ++k) {
    const std::size_t next = (k + 1) % low.size();
    mesh.add_triangle(low[k], high[next], high[k], labels);
    mesh.add_triangle(low[k], low[next], high[next], labels);
  }
}

std::vector<Ring> add_cap(SurfaceMesh& mesh, const CapShape& shape, const Ring& circle, lostopos::Region inside) {
  const long last = shape.rings - shape.overlap;
  const double step = std::numbers::pi / static_cast<double>(shape.rings);
  const double centre = shape.side * shape.radius * std::cos(step * static_cast<double>(shape.overlap));
  const auto distance = [&](long i) {
    return shape.radius * (1 - shape.taper * (1 - static_cast<double>(i) / static_cast<double>(last)));
  };
  const Vertex pole = add_point(mesh, centre + shape.side * distance(0));
  const Labels outwards{inside, lostopos::air};
  std::vector<Ring> rings;
  for (long i = 1; i <= last; ++i) {
    const double polar = step * static_cast<double>(i), r = distance(i);
    rings.push_back(i == last ? circle
                              : add_ring(mesh, static_cast<long>(circle.size()),
                                         centre + shape.side * r * std::cos(polar), r * std::sin(polar)));
    if (i == 1)
      add_fan(mesh, pole, rings.back(), shape.side > 0 ? outwards : outwards.flipped());
    else if (shape.side > 0)
      add_belt(mesh, rings.back(), rings[rings.size() - 2], outwards);
    else
      add_belt(mesh, rings[rings.size() - 2], rings.back(), outwards);
  }
  return rings;
}

double circle_radius(const CapShape& shape) {
  return shape.radius *
         std::sin(std::numbers::pi * static_cast<double>(shape.overlap) / static_cast<double>(shape.rings));
}

}  // namespace foamsim
