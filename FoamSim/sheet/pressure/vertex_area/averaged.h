#pragma once

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

/// The mean over the regions at the vertex of each region's own area, the same for all of them (Fei et al. 2019, "Our
/// solution"): balanced like a constant, true to the local triangles like the naive area; angles converge to 120°.
class AveragedArea final : public VertexArea {
 public:
  void evaluate(const VertexStar& star, std::span<double> area) const override;
};

}  // namespace foamsim
