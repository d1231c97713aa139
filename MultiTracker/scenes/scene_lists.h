#pragma once

#include <vector>

#include "MultiTracker/scenes/scene.h"

namespace multitracker {

/// The option "subdivisions" of a scene's start surface, 0 to 8.
base::OptionSpec subdivisions(long count);

/// Triangles of a surface of so many that are subdivided as its option "subdivisions" says.
double subdivided(double coarsest, const base::OptionSet& options);

/// The scene with the number of its triangles.
SceneEntry sized(SceneEntry scene, double (*triangles)(const base::OptionSet&));

/// enright, rotation, zalesak, noise: carried by velocity fields.
std::vector<SceneEntry> prescribed_scenes();
/// normal-flow, merge, coalescence, cyclicflow: films that move along their normals.
std::vector<SceneEntry> growth_scenes();
/// T1, T2, mcf, catenoid: films under tension.
std::vector<SceneEntry> film_scenes();

}  // namespace multitracker
