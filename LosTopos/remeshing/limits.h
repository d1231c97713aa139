#pragma once

#include "LosTopos/remeshing/remesh_options.h"

namespace lostopos {

/// The bounds of RemeshOptions in absolute units (L, L², L³, radians).
struct Limits {
  double shortest_edge, longest_edge, min_area, min_angle, max_angle, max_volume_change, split_angle;
};

/// Throws InputError when an option makes no sense (not finite, not positive, bounds in the wrong order).
Limits limits_of(const RemeshOptions& options);

/// For aggressive rounds: ten times the volume change, half as much again for the longest edge, no smallest area; a
/// shape that is out of bounds must still not get worse.
Limits relaxed(const Limits& limits);

}  // namespace lostopos
