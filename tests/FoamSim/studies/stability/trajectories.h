#pragma once

#include "FoamSim/studies/stability/trajectory.h"

namespace foamsim::test {

/// A made-up motion of one bubble in the air with `steps` steps, in which nothing changes: within all limits of
/// physics.
inline Trajectory quiet_trajectory(long steps = 4) {
  Trajectory t;
  t.steps_asked = steps;
  for (long i = 0; i <= steps; ++i) {
    Metrics m;
    m.step = i;
    m.time = 0.01 * static_cast<double>(i);
    m.vertices = 2;
    m.triangles = 4;
    m.regions = 2;
    m.area = 4;
    m.energy = 16;
    m.impulse_scale = 2;
    m.volumes = {{lostopos::air, -1.0}, {lostopos::Region(1), 1.0}};
    m.triangle_angle_min_deg = 30;
    t.samples.push_back(m);
  }
  t.end_positions = {{1, 0, 0}, {0, 1, 0}};
  return t;
}

}  // namespace foamsim::test
