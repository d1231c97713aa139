#pragma once

#include <string>
#include <vector>

#include "LosTopos/reference_options.h"
#include "MultiTracker/scenes/scene.h"

namespace multitracker {

/// Every key that the reference tracker's option files may have, and what it means here.
const std::vector<lostopos::ReferenceKey>& reference_keys();

/// What an option file of the reference tracker asks for.
struct ReferenceScene {
  const SceneEntry* scene;  ///< not null
  base::OptionSet options;
  std::string mesh_file;  ///< SCENE.arec beside the file; empty: there is none, and the surface is the scene's own
  std::vector<std::string> notes;  ///< what was read and has no meaning here
};

/// Reads an option file of the reference tracker (docs/reference-options.md). Keys that are absent have its defaults;
/// films under tension move by the gradient of their area, as there. Throws base::InputError with file and line for
/// unknown keys and bad values.
ReferenceScene read_reference_options(const std::string& file);

}  // namespace multitracker
