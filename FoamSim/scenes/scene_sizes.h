#pragma once

#include <functional>
#include <string>

#include "Base/options/option_set.h"
#include "FoamSim/scenes/scene_registry.h"

namespace foamsim {

using base::whole_between;

/// Option `n` of scenes whose triangles are each divided into four n times.
base::OptionSpec subdivisions(long default_value, std::string summary, long least = 0);

/// How many triangles such a scene has: `coarsest` · 4ⁿ.
std::function<double(const base::OptionSet&)> triangles_of_subdivided(double coarsest);

/// How many triangles `surfaces` surfaces of rings have, of options `n` and `m` (m where there is none, or it is 0: as
/// many as n).
std::function<double(const base::OptionSet&)> triangles_of_rings(double surfaces);

/// The scene with the number of its triangles.
SceneEntry sized(SceneEntry scene, std::function<double(const base::OptionSet&)> triangles);

/// A number whose magnitude is below a bound.
base::OptionSpec number_below(double bound, const std::string& bound_text, std::string key, double default_value,
                              std::string summary);

}  // namespace foamsim
