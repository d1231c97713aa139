#include "FoamSim/sheet/energy.h"

#include <Eigen/Geometry>
#include <cmath>

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

Vec3 area_vector(const std::array<Vertex, 3>& v, std::span<const Vec3> positions) {
  const Vec3& a = positions[v[0].index()];
  return 0.5 * (positions[v[1].index()] - a).cross(positions[v[2].index()] - a);
}

}  // namespace

double kinetic_energy(std::span<const double> circulation, std::span<const SheetTriangle> sheet,
                      std::span<const Vec3> positions, std::span<const Vec3> velocity) {
  double sum = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const auto& v = sheet[i].vertices;
    const Vec3 u = (velocity[v[0].index()] + velocity[v[1].index()] + velocity[v[2].index()]) / 3.0;
    sum -= circulation[i] * u.dot(area_vector(v, positions));
  }
  return sum;
}

Impulse hydrodynamic_impulse(std::span<const double> circulation, std::span<const SheetTriangle> sheet,
                             std::span<const Vec3> positions) {
  Impulse impulse{Vec3::Zero(), 0};
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const Vec3 part = 2 * circulation[i] * area_vector(sheet[i].vertices, positions);
    impulse.total += part;
    impulse.scale += part.norm();
  }
  return impulse;
}

}  // namespace foamsim
