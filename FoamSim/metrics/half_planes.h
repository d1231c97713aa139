#pragma once

#include <array>
#include <optional>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// One of the three films at a Plateau border, seen along the border.
struct HalfPlane {
  double angle;                   ///< about the border, counter-clockwise, radians
  lostopos::Region region_after;  ///< the region met when the turn goes on
};

/// Statistics of the angles between the three films of many places on Plateau borders.
class DihedralAngles {
 public:
  /// Takes the three films at a place, in any order; their angles lie within one turn.
  void add(std::array<HalfPlane, 3> planes);
  /// RMS of (angle − 120°) over all angles, degrees; empty without any.
  std::optional<double> rms_deviation_deg() const;
  /// Mean of the angles on the air's side, degrees; empty without any.
  std::optional<double> outer_mean_deg() const;
  std::size_t places() const { return places_; }

 private:
  double squares_ = 0, outer_sum_ = 0;
  std::size_t places_ = 0, outer_ = 0;
};

}  // namespace foamsim
