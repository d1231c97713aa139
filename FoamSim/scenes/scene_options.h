#pragma once

#include <span>
#include <string>
#include <vector>

#include "Base/options/option_set.h"
#include "FoamSim/scenes/catalogue.h"

namespace foamsim {

/// What acts on the films. Dynamics that are not told otherwise keep volumes, but for the vortex sheet, and leave out
/// what does not suit them: conservative ones `diffusion`, which can win energy there, relaxation all that acts on the
/// air.
std::vector<std::string> effects_of(const base::OptionSet& options);

/// The options as the scene uses them: with the defaults that other options bring along (those of `conservative`:
/// effects and bounds of remeshing) filled in.
base::OptionSet options_in_use(const base::OptionSet& options);

/// The options that every scene has, with their defaults: the general ones, the tracker's, and those of every effect,
/// strategy and so on of the catalogue.
std::vector<base::OptionSpec> common_option_specs(const Catalogue& catalogue);
/// These and the own ones of all scenes, each key once: what --set may be followed by.
std::vector<base::OptionSpec> all_option_specs(const Catalogue& catalogue);
/// The options of a built-in scene, its own first, or with null of a scene that starts from a mesh file.
base::OptionSet options_of(const Catalogue& catalogue, const SceneEntry* scene);

/// Whether a wire or a rod holds films, so that the air goes with them.
bool holds_by_wire(const base::OptionSet& options);

/// Whether `name` is one of `names`.
bool names_have(std::span<const std::string> names, std::string_view name);

}  // namespace foamsim
