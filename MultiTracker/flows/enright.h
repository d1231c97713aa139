#pragma once

#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// The divergence-free vortex pair of LeVeque 1996 in the unit box, as Enright et al. 2002 use it: it draws a sphere
/// out into a thin sheet and, its sign turning with cos(πt/T), back again; period T = 3.
class EnrightFlow final : public Flow {
 public:
  lostopos::Vec3 velocity(const lostopos::Vec3& x, double time) const override;
  double period() const override { return 3; }
};

}  // namespace multitracker
