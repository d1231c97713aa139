#include "FoamSim/sheet/pressure/edge_angle.h"

namespace foamsim {

void EdgeAngle::evaluate(const PressureInput& input, Pressures& pressures) {
  evaluate_curvature(input.mesh, input.geometry, curvature_, pressures.values);
  pressures.coefficient = input.sigma;
}

}  // namespace foamsim
