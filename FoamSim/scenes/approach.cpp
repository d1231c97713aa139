#include "FoamSim/scenes/approach.h"

namespace foamsim {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

void approach(const SurfaceMesh& mesh, double gap, double speed, CirculationField& circulation) {
  for (Vertex v : mesh.vertices()) {
    const double x = mesh.position(v).x();
    const int side = x < 0 ? -1 : 1;
    const double from_centre = x - side * (1 + gap / 2);
    circulation.set(v, {Region(side < 0 ? 1 : 2), air}, -0.75 * (-side * speed) * from_centre);
  }
}

}  // namespace foamsim
