#pragma once

#include <vector>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/constraints/constraint.h"

namespace foamsim {

/// What a constraint may be made from.
struct ConstraintSetup {
  const base::OptionSet& options;
  double resolution;                           ///< h̄, L
  const std::vector<lostopos::Vertex>& edges;  ///< where films end: free edges, and what a mesh file says is held
};
using ConstraintEntry = base::Model<Constraint, ConstraintSetup>;

/// The built-in constraints: frame, wire, rod. `make` gives null where there is nothing to hold.
const base::Registry<ConstraintEntry>& constraints();

}  // namespace foamsim
