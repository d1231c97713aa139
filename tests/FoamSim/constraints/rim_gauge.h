#pragma once

#include "FoamSim/scenes/scene.h"

namespace foamsim::test {

/// What goes on at the rim of a straw or wand, summed over the steps: out of the bubble, and of the air without the
/// wire's own motion.
struct RimFlow {
  double through = 0;  ///< volume of air through the rim, by the vector potential round it, L³
  /// What the film's triangles at the rim would have let the bubble grow by, had their corners there gone with the air
  /// as the others do, L³.
  double at_rim = 0;
  lostopos::Vec3 rim_share =
      lostopos::Vec3::Zero();  ///< area of the film that goes with these corners, times time, L²T
};

/// The same scene with a gauge at the rim, which adds to `flow` at the circulation that each step moves the films with,
/// and changes nothing. `flow` has to outlive the simulation.
Scene gauged(const Scene& scene, RimFlow& flow);

/// Area vector of the rim of a straw or wand, out of its bubble, L².
lostopos::Vec3 rim_area(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid);

}  // namespace foamsim::test
