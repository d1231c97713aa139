#pragma once

#include <string>
#include <vector>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// The word that stands for the conservative dynamics where methods are compared; the others are area strategies.
inline constexpr const char* conservative_method = "conservative";

/// What can be compared under one name: every area strategy of the vortex sheet, and `conservative`.
std::vector<std::string> method_names(const Catalogue& catalogue);

/// Throws base::InputError with the nearest name for one that is none of these.
void require_method(const Catalogue& catalogue, const std::string& method);

/// Sets the options of a scene so that it is run with the method. The conservative one takes `volumes`, and a
/// viscosity of 0.1 in place of `diffusion`, which belongs to the vortex sheet. What was set of other methods is unset.
/// `where`: who asks, for messages.
void choose_method(base::OptionSet& options, const std::string& method, const std::string& where);

/// What a scene may have options of although its own method does not use it, when several methods are compared.
std::vector<std::string> also_used_by(const std::vector<std::string>& methods);

}  // namespace foamsim
