#pragma once

#include <vector>

#include "FoamSim/scenes/scene_registry.h"

namespace foamsim {

/// @name The built-in scenes by subject: each list in a file of its name.
///@{
std::vector<SceneEntry> closed_scenes();    ///< bubbles in the air that nothing holds
std::vector<SceneEntry> junction_scenes();  ///< films that meet, free or in a frame
std::vector<SceneEntry> wire_scenes();  ///< films held by wires: wands, straws, rods, rings on bubbles, frames of wire
std::vector<SceneEntry> foam_scenes();  ///< many bubbles: foams, and how they are made
///@}

}  // namespace foamsim
