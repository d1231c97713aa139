#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "FoamSim/dynamics/simulation.h"

namespace foamsim::test {

/// Surface tension σ = `sigma` under edge angles with an area strategy.
std::unique_ptr<Effect> tension(double sigma = 1, std::string_view area = "averaged");

/// A simulation's parts: direct sums, an integrator by name, and these effects.
SimulationParts parts(std::vector<std::unique_ptr<Effect>> effects = {}, std::string_view integrator = "euler");
/// The same with one effect.
SimulationParts parts(std::unique_ptr<Effect> effect, std::string_view integrator = "euler");

}  // namespace foamsim::test
