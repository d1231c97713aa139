#pragma once

#include <string>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// Reads an option file of the reference program (docs/method.md "File formats"): one `key value` a line, # comments.
/// Keys that have no meaning here become notes of the scene. Its clock alternates dynamics and remeshing ticks, ours
/// does both in one step: `simulation-time` is halved. Throws base::InputError with file and line for unknown keys and
/// bad values.
Scene read_reference_options(const std::string& file, std::shared_ptr<const Catalogue> catalogue);

}  // namespace foamsim
