#pragma once

#include "FoamSim/studies/stability/stability_case.h"

namespace foamsim::stability {

StabilityCase long_double_bubble();
StabilityCase volume_ratio();
StabilityCase stretched_border();
StabilityCase border_slivers();
StabilityCase time_steps();
StabilityCase displaced_quad_point();
StabilityCase meeting_off_axis();
StabilityCase t1_threshold();
StabilityCase shrinking_bubble();
StabilityCase scaled_lengths();
StabilityCase moved_origin();
StabilityCase vertex_noise();
StabilityCase random_foam();
StabilityCase fine_foam();
StabilityCase large_foam();

}  // namespace foamsim::stability
