#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim::test {

using LongVec3 = Eigen::Matrix<long double, 3, 1>;

/// One target's velocity, and what its rounding error is measured against.
struct OracleVelocity {
  LongVec3 velocity = LongVec3::Zero();
  long double term_sum = 0;  ///< (1/4π) Σ_t |γ_t × (x − m_t)| / (|x − m_t|² + δ²)^{3/2}
};

/// The Biot–Savart sum of BiotSavart::velocities as a plain loop in long double; a source gives nothing to its own
/// point.
std::vector<OracleVelocity> biot_savart_oracle(const VortexSources& sources, std::span<const lostopos::Vec3> targets,
                                               double delta);

}  // namespace foamsim::test
