#pragma once

#include "FoamSim/dynamics/dynamics.h"
#include "FoamSim/dynamics/integrator.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/pair_sums.h"

namespace foamsim {

/// The dynamics of Da et al. 2015 (docs/method.md "The step"): effects change Γ, the sheet's Biot–Savart velocities
/// move the vertices.
class VortexSheet final : public Dynamics {
 public:
  /// Neither null.
  VortexSheet(const std::shared_ptr<const BiotSavart>& sum, std::unique_ptr<Integrator> integrator)
      : velocity_(sum), pairs_(sum->pair_sums(Precision::doubles)), integrator_(std::move(integrator)) {}

  double attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) override;
  bool takes_tension() const override { return integrator_->takes_tension(); }
  AirState air(const EffectStep& step, CirculationField& circulation) override;
  void before_burst(const EffectStep& step, CirculationField& circulation, lostopos::Region region) override;
  void advance(StepScope& scope, std::vector<lostopos::Vec3>& predicted) override;

 private:
  // What drives the air from outside: the vortices before it, and its change of them.
  struct Drive {
    VortexSources before = {}, change = {};
  };
  Drive drive(StepScope& scope);
  double work_of(const Drive& drive, StepScope& scope);
  // Γ̄ of the sheet's triangles as they are now, without region constants.
  std::vector<double> gather_circulation(StepScope& scope);
  void change_circulation(StepScope& scope);
  void kick(StepScope& scope);
  void let_in(StepScope& scope) const;
  void predict(StepScope& scope, std::vector<lostopos::Vec3>& predicted);
  static void count_wire_work(StepScope& scope, std::span<const lostopos::Vec3> predicted);
  void measure(StepScope& scope, std::span<const double> before, std::span<const double> after) const;

  SheetVelocity velocity_;
  std::unique_ptr<PairSummation> pairs_;
  std::unique_ptr<Integrator> integrator_;
  double delta_ = 0;
  std::vector<SheetTriangle> sheet_;
  std::vector<lostopos::Vec3> velocities_;
};

}  // namespace foamsim
