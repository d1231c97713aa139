#include "FoamSim/scenes/shapes/solids.h"

#include <cmath>

namespace foamsim {

void perturb_with_mode(lostopos::SurfaceMesh& mesh, long mode, double amplitude) {
  for (lostopos::Vertex v : mesh.vertices()) {
    const lostopos::Vec3 x = mesh.position(v);
    const double legendre = std::legendre(static_cast<unsigned>(mode), x.x() / x.norm());
    mesh.set_position(v, x * (1 + amplitude * legendre));
  }
}

}  // namespace foamsim
