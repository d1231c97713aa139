#pragma once

#include <vector>

#include "Base/options/option_set.h"
#include "LosTopos/surface_tracker.h"

namespace lostopos {

/// Memory of a process that tracks a surface, for each of its triangles: mesh, attributes, the searches' boxes, and
/// what a step keeps for the case that it fails (docs/scale.md).
inline constexpr double default_bytes_of_triangle = 2000;

/// The tracker's options as keys tracker.*, remeshing.* and topology.*, with the defaults of `defaults`, and
/// memory_limit (see memory_limit.h). The resolution is not among them: what it means by default is the program's to
/// say.
std::vector<base::OptionSpec> tracker_option_specs(const TrackerOptions& defaults);

/// The tracker's options as set; the resolution is left 0. `options` must have the specs above.
/// `bytes_of_triangle`: memory that the caller's program takes for each, from which memory_limit bounds how many
/// remeshing may make.
TrackerOptions tracker_options(const base::OptionSet& options, double bytes_of_triangle = default_bytes_of_triangle);

}  // namespace lostopos
