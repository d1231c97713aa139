#pragma once

#include <string>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/reference_options.h"

namespace foamsim {

/// Every key that the reference program's option files may have, and what it means here.
const std::vector<lostopos::ReferenceKey>& reference_keys();

/// Reads an option file of the reference program (docs/reference-options.md): one `key value` a line, # comments. Keys
/// that are absent have the reference's defaults, not ours. Its clock alternates dynamics and remeshing ticks, ours
/// does both in one step: rates double, times halve, diffusion acts twice. What has no meaning here, or none in this
/// scene, becomes a note of the scene. Throws base::InputError with file and line for unknown keys and bad values.
Scene read_reference_options(const std::string& file, std::shared_ptr<const Catalogue> catalogue);

}  // namespace foamsim
