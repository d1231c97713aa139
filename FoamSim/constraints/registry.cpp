#include "FoamSim/constraints/registry.h"

#include "FoamSim/constraints/fixed_frame.h"

namespace foamsim {

const base::Registry<ConstraintEntry>& constraints() {
  static const base::Registry<ConstraintEntry> entries(
      "constraint", {{"frame",
                      "films that end at a free edge end at a frame that stands still",
                      {},
                      [](const ConstraintSetup& setup) -> std::unique_ptr<Constraint> {
                        return std::make_unique<FixedFrame>(setup.edges);
                      }}});
  return entries;
}

}  // namespace foamsim
