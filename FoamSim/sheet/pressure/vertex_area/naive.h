#pragma once

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

/// Every region by its own triangles, junction or not. At a junction, stretching one film changes the curvature of two
/// regions and not of the third, so the forces lose their balance: the double bubble drifts off (report, figure 1 top).
class NaiveArea final : public VertexArea {
 public:
  void evaluate(const VertexStar& star, std::span<double> area) const override { area_of_own_triangles(star, area); }
};

}  // namespace foamsim
