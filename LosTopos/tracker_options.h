#pragma once

#include <vector>

#include "Base/options/option_set.h"
#include "LosTopos/surface_tracker.h"

namespace lostopos {

/// The tracker's options as keys tracker.*, remeshing.* and topology.*, with the defaults of `defaults`. The resolution
/// is not among them: what it means by default is the program's to say.
std::vector<base::OptionSpec> tracker_option_specs(const TrackerOptions& defaults);

/// The tracker's options as set; the resolution is left 0. `options` must have the specs above.
TrackerOptions tracker_options(const base::OptionSet& options);

}  // namespace lostopos
