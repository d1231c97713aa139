#pragma once

#include <string>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// Reads a TOML scene file: `scene = "NAME"` (a built-in shape) or `mesh = "FILE"` (relative to the scene file), and
/// any option; a table [a] with key b is option a.b. Tables [[wire]] with `vertices` or `selection`, `motion`, `from`
/// and `until` are wires, see WireSpec; with them constraints = wire unless the file says otherwise. Throws
/// base::InputError with file and line.
Scene read_toml_scene(const std::string& file, std::shared_ptr<const Catalogue> catalogue);

}  // namespace foamsim
