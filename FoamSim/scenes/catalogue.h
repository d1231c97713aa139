#pragma once

#include <memory>

#include "FoamSim/constraints/registry.h"
#include "FoamSim/dynamics/integrator.h"
#include "FoamSim/dynamics/registry.h"
#include "FoamSim/effects/registry.h"
#include "FoamSim/scenes/scene_registry.h"
#include "FoamSim/sheet/sheet_models.h"

namespace foamsim {

/// Everything that users choose by name. A program with models of its own copies the built-in one, adds them, and hands
/// it to load_scene or run_program:
///
///     auto mine = std::make_shared<Catalogue>(*built_in_catalogue());
///     mine->effects.add({"wind", "blows along x", {base::non_negative_number("wind", 1, "speed, L/T")}, make_wind});
struct Catalogue {
  SheetModels sheet;  ///< area strategies, pressure schemes, velocity sums
  base::Registry<EffectEntry> effects = built_in_effects();
  base::Registry<ConstraintEntry> constraints = foamsim::constraints();
  base::Registry<IntegratorEntry> integrators = foamsim::integrators();
  base::Registry<DynamicsEntry> dynamics = dynamics_schemes();
  base::Registry<SceneEntry> scenes = built_in_scenes();
};

/// What FoamSim itself has; the same object for all.
std::shared_ptr<const Catalogue> built_in_catalogue();

}  // namespace foamsim
