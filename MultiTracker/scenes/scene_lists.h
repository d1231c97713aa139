#pragma once

#include <vector>

#include "MultiTracker/scenes/scene.h"

namespace multitracker {

/// The option "subdivisions" of a scene's start surface, 0 to 8.
base::OptionSpec subdivisions(long count);

/// enright, rotation, zalesak, noise: carried by velocity fields.
std::vector<SceneEntry> prescribed_scenes();
/// normal-flow, merge, coalescence, cyclicflow: films that move along their normals.
std::vector<SceneEntry> growth_scenes();
/// T1, T2, mcf, catenoid: films under tension.
std::vector<SceneEntry> film_scenes();

}  // namespace multitracker
