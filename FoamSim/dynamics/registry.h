#pragma once

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/dynamics/dynamics.h"
#include "FoamSim/dynamics/integrator.h"
#include "FoamSim/sheet/sheet_models.h"

namespace foamsim {

/// What dynamics may be made from: the options, with their own, and what else is chosen by name.
struct DynamicsSetup {
  const base::OptionSet& options;
  const SheetModels& sheet;
  const base::Registry<IntegratorEntry>& integrators;
};
using DynamicsEntry = base::Model<Dynamics, DynamicsSetup>;

/// The built-in dynamics: vortex-sheet, conservative, relaxation.
const base::Registry<DynamicsEntry>& dynamics_schemes();

}  // namespace foamsim
