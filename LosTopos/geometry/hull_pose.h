#pragma once

#include <array>

#include "LosTopos/geometry/moving_hull.h"

namespace lostopos {

/// A part of a hull's boundary.
struct HullFeature {
  enum class Kind { face, edge, corner };
  Kind kind;
  int index = 0;  ///< of the edge or corner
};

/// A moving hull at one time, and the directions of planes that may separate it from the origin there.
class HullPose {
 public:
  HullPose(const MovingHull& hull, double t);

  /// The feature that is nearest to the origin, up to rounding.
  HullFeature nearest_feature() const;

  /// Of the line from the origin to the nearest point of the feature's plane, edge's line or corner; not normalised. It
  /// is normal to the feature to the last digits even when the origin is very near.
  Vec3 direction(const HullFeature& feature) const;

  /// The same at this time, but it turns with the edge and so stays normal to it.
  MovingVector turning_edge_direction(int edge) const;

  int edge_count() const { return hull_.size == 3 ? 3 : 4; }
  int corner_count() const { return hull_.size; }

 private:
  HullFeature nearest_of_triangle() const;
  HullFeature nearest_of_edges() const;

  const MovingHull& hull_;
  std::array<Vec3, 4> corners_;
  Vec3 e1_;
  Vec3 e2_;
};

}  // namespace lostopos
