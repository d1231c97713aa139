#pragma once

#include <array>
#include <optional>
#include <string>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// The resolutions of the report's table (Fei et al. 2019): subdivisions N of each bubble.
inline constexpr std::array<long, 4> report_subdivisions{16, 24, 48, 96};
/// Its three strategies, in the order of its figure 1.
inline constexpr std::array<const char*, 3> report_areas{"naive", "constant-edge", "averaged"};
/// These, and our own scheme beside them.
inline constexpr std::array<const char*, 4> compared_methods{"naive", "constant-edge", "averaged", "conservative"};

/// RMS deviation from 120°, degrees, that the report gives for its own method (`averaged`) with N subdivisions; empty
/// where it gives none.
std::optional<double> published_deviation(long n);

/// The report's double bubble: dt 0.01, σ 1, diffusion 10, h̄ of the start mesh, remeshing after every step by splits,
/// collapses and flips, without smoothing; constant-edge with φ = 0.75, what the published code's constant comes to. No
/// damping. Beyond N = 48 dt 0.005 and diffusion 20, which is what the published program's rate of 10 comes to on its
/// clock. `area`: a strategy's name. Throws base::InputError.
Scene report_scene(long n, const std::string& area);

/// The same, brought to rest sooner: it swings freely for four units of time, in which the start shape opens to a
/// double bubble, overshoots, and its border is remeshed; after that circulation decays by the factor 0.02 in a unit of
/// time, about critically for the slowest mode. Beyond N = 48 it does so from the start.
Scene report_scene_to_rest(long n, const std::string& area);

}  // namespace foamsim
