#pragma once

#include <boost/container/small_vector.hpp>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/remeshing/change_plan.h"
#include "LosTopos/remeshing/limits.h"

namespace lostopos {

/// By how much a plan changes the volume of each region, by the divergence theorem.
class VolumeChange {
 public:
  /// What a region gains (L³), and the gradient of that with respect to the position of one vertex (L²).
  struct OfRegion {
    Region region;
    double volume = 0;
    Vec3 gradient = Vec3::Zero();
  };

  VolumeChange(const SurfaceMesh& mesh, const ChangePlan& plan) : VolumeChange(mesh, plan, Vertex()) {}
  /// With gradients for the planned triangles' corners at `moving`.
  VolumeChange(const SurfaceMesh& mesh, const ChangePlan& plan, Vertex moving);

  /// The largest gain or loss of a region, not negative.
  double largest() const;
  const auto& regions() const { return regions_; }

  /// The shortest displacement of the vertex that undoes all the gains and losses, exactly where the surface is closed
  /// (volumes are linear in the position of one vertex): the least-norm solution of gradient_r · d = −volume_r over all
  /// regions r. On a film it is along the normal, on a junction curve across it. Directions in which the volumes hardly
  /// depend on the position (eigenvalues of Σ g gᵀ below 1% of the largest) are left out. Held coordinates of the
  /// vertex stay, to the bit.
  Vec3 restoring_shift(Hold hold = Hold::none) const;

 private:
  OfRegion& at(Region region);
  void add(const Corners& corners, Labels labels, double sign, const Vec3& origin);
  void add_gradient(const PlannedTriangle& planned, Vertex moving);

  boost::container::small_vector<OfRegion, 8> regions_;
};

/// No region's volume changes by more than its bound.
bool keeps_volumes(const ChangePlan& plan, const Limits& limits);

}  // namespace lostopos
