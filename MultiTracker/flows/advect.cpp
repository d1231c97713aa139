#include "MultiTracker/flows/advect.h"

#include <vector>

#include "Base/parallel/for_each.h"

namespace multitracker {

using lostopos::Vec3;

namespace {

Vec3 moved(const Flow& flow, const Vec3& x, double time, double dt) {
  const Vec3 k1 = flow.velocity(x, time);
  const Vec3 k2 = flow.velocity(x + dt / 2 * k1, time + dt / 2);
  const Vec3 k3 = flow.velocity(x + dt / 2 * k2, time + dt / 2);
  const Vec3 k4 = flow.velocity(x + dt * k3, time + dt);
  return x + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace

std::vector<Vec3> carried(const Flow& flow, std::span<const Vec3> points, double time, double dt) {
  std::vector<Vec3> ends(points.size());
  base::parallel_for_each(points.size(), 256, [&](std::size_t i) { ends[i] = moved(flow, points[i], time, dt); });
  return ends;
}

void advect(lostopos::SurfaceTracker& tracker, const Flow& flow, double time, double dt) {
  tracker.advance(carried(flow, tracker.mesh().positions(), time, dt));
}

}  // namespace multitracker
