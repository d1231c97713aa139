#pragma once

#include "FoamSim/sheet/circulation.h"

namespace foamsim {

/// Before region A bursts (docs/method.md "Effects"): Γ of its films towards other regions B, which then are films of
/// the air, becomes Γ^{0B}. Where both meet it is the mean of Γ^{0B} and Γ^{AB}; elsewhere each is shifted by half of
/// the difference D_B of their means over these vertices, so that they join without a jump: Γ^{0B} − D_B/2 and Γ^{AB} +
/// D_B/2. Γ^{AB} is then dropped. D_B is 0 where no vertex has both.
void join_circulation_to_air(const lostopos::SurfaceMesh& mesh, lostopos::Region bursting,
                             CirculationField& circulation);

}  // namespace foamsim
