#pragma once

#include <memory>

#include "FoamSim/sheet/pressure/curvature.h"
#include "FoamSim/sheet/pressure/pressure_scheme.h"

namespace foamsim {

/// Edge angle over area (Da et al. 2015): P_v^r = H_v^r, coefficient σ, so that dΓ_v^{pq}/dt = σ (H_v^p − H_v^q): the
/// pressure jump of curved films. The area strategy is what the report's three methods differ in.
class EdgeAngle final : public PressureScheme {
 public:
  explicit EdgeAngle(std::unique_ptr<VertexArea> area) : curvature_(std::move(area)) {}
  void evaluate(const PressureInput& input, Pressures& pressures) override;

 private:
  EdgeAngleCurvature curvature_;
};

}  // namespace foamsim
