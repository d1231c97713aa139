#pragma once

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

/// `averaged`, with each region's share in proportion to the length of the Plateau borders at the vertex that bound it.
/// Along a border all regions are bounded by the same edges, and nothing changes. At a Plateau vertex a region lacks
/// one of the four borders: where films meet at 120° its integrated curvature is π/3 times the length of its three, so
/// that one area for all regions makes forces of edges that are merely unequal, and this makes none. Not in Fei et al.
/// 2019, whose junction has three regions; derived and measured in docs/accuracy.md, "Beyond the report".
class BorderLengthArea final : public VertexArea {
 public:
  void evaluate(const VertexStar& star, std::span<double> area) const override;
};

}  // namespace foamsim
