#pragma once

#include <memory>
#include <span>
#include <vector>

#include "FoamSim/sheet/sheet_strength.h"
#include "FoamSim/sheet/velocity/biot_savart.h"

namespace foamsim {

/// The velocity that a vortex sheet induces at its own vertices (docs/method.md "The step", 3). Holds the work arrays,
/// so that evaluating it in every step allocates nothing.
class SheetVelocity {
 public:
  explicit SheetVelocity(std::shared_ptr<const BiotSavart> sum) : sum_(std::move(sum)) {}

  /// u (L/T) at `targets` from the sheet with vertices at `positions` (indexed by vertex handle); `delta` is the
  /// regularisation δ (L).
  void evaluate(std::span<const SheetTriangle> sheet, std::span<const lostopos::Vec3> positions,
                std::span<const lostopos::Vec3> targets, double delta, std::span<lostopos::Vec3> velocity);

  /// How often evaluate was called.
  long evaluations() const { return evaluations_; }

 private:
  std::shared_ptr<const BiotSavart> sum_;
  VortexSources sources_;
  long evaluations_ = 0;
};

}  // namespace foamsim
