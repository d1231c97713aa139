#pragma once

#include "LosTopos/surface_tracker.h"
#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// Moves every vertex along the flow from `time` to time + dt (T) by the classical fourth-order Runge–Kutta method and
/// hands the positions to the tracker. Throws what SurfaceTracker::advance throws.
void advect(lostopos::SurfaceTracker& tracker, const Flow& flow, double time, double dt);

}  // namespace multitracker
