#pragma once

#include <string>
#include <vector>

#include "FoamSim/run/checkpoint.h"

namespace foamsim {

/// What an audit finds on the surface that a user should know. Throws base::InputError for a surface that cannot be
/// simulated.
std::vector<std::string> check_surface(const Simulation& simulation);

/// Looks at what a run starts from, and returns what its user should know: what the scene says of it, what an audit of
/// the surface finds, open edges that a mesh file does not say are held, and a resolution that bubbles cannot carry.
/// Throws base::InputError for a surface that cannot be simulated, and for a resolution above the radius of the
/// smallest bubble where the scene asks for it: remeshing would take that bubble away.
std::vector<std::string> check_start(const Scene& scene, const Simulation& simulation, const StartOfRun& start);

}  // namespace foamsim
