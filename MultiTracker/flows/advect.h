#pragma once

#include <span>
#include <vector>

#include "LosTopos/surface_tracker.h"
#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// Where the points (L) are dt (T) after `time` when the flow carries them, by the classical fourth-order Runge–Kutta
/// method.
std::vector<lostopos::Vec3> carried(const Flow& flow, std::span<const lostopos::Vec3> points, double time, double dt);

/// Moves every vertex along the flow from `time` to time + dt (T), see `carried`, as far as the tracker allows. Throws
/// what SurfaceTracker::advance throws.
void advect(lostopos::SurfaceTracker& tracker, const Flow& flow, double time, double dt);

}  // namespace multitracker
