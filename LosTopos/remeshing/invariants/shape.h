#pragma once

#include "LosTopos/remeshing/invariants/invariant.h"

namespace lostopos {

// Bounds of shape. A bound is broken by a plan whose result is beyond it and worse than what was there before: a bad
// neighbourhood can always be made better.

bool keeps_min_angle(const ChangePlan& plan, const Limits& limits);
bool keeps_max_angle(const ChangePlan& plan, const Limits& limits);
bool keeps_min_area(const ChangePlan& plan, const Limits& limits);
bool keeps_longest_edge(const ChangePlan& plan, const Limits& limits);
/// No triangle turns by a right angle or more against what it replaces, or collapses to a line.
bool keeps_orientation(const ChangePlan& plan, const Limits& limits);

/// The smallest angle grows, by a relative 1e-6 at least: operations that only improve end by themselves.
bool improves_min_angle(const ChangePlan& plan, const Limits& limits);

}  // namespace lostopos
