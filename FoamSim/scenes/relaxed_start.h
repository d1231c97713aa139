#pragma once

#include <functional>

#include "FoamSim/dynamics/simulation.h"

namespace foamsim {

/// Told after each of `of` steps how many are done; false: the rest is left out.
using RelaxationProgress = std::function<bool(long done, long of)>;

/// A closed surface after `steps` steps of Relaxation with bubbles at their volumes, tracked as `options` say, at rest.
/// `sigma`: tension of one film side over density, L³/T². Throws base::InputError where sigma is 0, and
/// lostopos::MotionError where the surface cannot be moved.
lostopos::SurfaceMesh relaxed_start(lostopos::SurfaceMesh surface, const SimulationOptions& options, double sigma,
                                    long steps, const RelaxationProgress& progress = {});

}  // namespace foamsim
