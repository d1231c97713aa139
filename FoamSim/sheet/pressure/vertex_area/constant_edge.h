#pragma once

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

/// At a junction vertex, for every region: φ h̄ Σ|e| over the junction edges at the vertex (Da et al. 2015). Balanced,
/// but blind to the real areas, so that angles rest far from 120° (report, figure 1 middle).
class ConstantEdgeArea final : public VertexArea {
 public:
  /// `phi`: dimensionless, > 0. h̄ is the mean edge length `resolution` (L) where that is positive, else the mesh's own.
  ConstantEdgeArea(double phi, double resolution) : phi_(phi), resolution_(resolution) {}
  void evaluate(const VertexStar& star, std::span<double> area) const override;

 private:
  double phi_, resolution_;
};

}  // namespace foamsim
