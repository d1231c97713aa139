#pragma once

#include "FoamSim/dynamics/dynamics.h"
#include "FoamSim/dynamics/integrator.h"
#include "FoamSim/sheet/velocity/sheet_velocity.h"

namespace foamsim {

/// The dynamics of Da et al. 2015 (docs/method.md "The step"): effects change Γ, the sheet's Biot–Savart velocities
/// move the vertices.
class VortexSheet final : public Dynamics {
 public:
  /// Neither null.
  VortexSheet(std::unique_ptr<BiotSavart> velocity, std::unique_ptr<Integrator> integrator)
      : velocity_(std::move(velocity)), integrator_(std::move(integrator)) {}

  double attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) override;
  void advance(StepScope& scope, std::vector<lostopos::Vec3>& predicted) override;

 private:
  // Γ̄ of the sheet's triangles as they are now, without region constants.
  std::vector<double> gather_circulation(StepScope& scope);
  void change_circulation(StepScope& scope);
  void predict(StepScope& scope, std::vector<lostopos::Vec3>& predicted);
  static void count_wire_work(StepScope& scope, std::span<const lostopos::Vec3> predicted);
  void measure(StepScope& scope, std::span<const double> before, std::span<const double> after) const;

  SheetVelocity velocity_;
  std::unique_ptr<Integrator> integrator_;
  double delta_ = 0;
  std::vector<SheetTriangle> sheet_;
  std::vector<lostopos::Vec3> velocities_;
};

}  // namespace foamsim
