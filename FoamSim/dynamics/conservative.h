#pragma once

#include <optional>

#include "FoamSim/conservative/burst_potential.h"
#include "FoamSim/conservative/correction.h"
#include "FoamSim/conservative/film_motion.h"
#include "FoamSim/conservative/film_shape.h"
#include "FoamSim/conservative/mesh_motion.h"
#include "FoamSim/conservative/potential.h"
#include "FoamSim/conservative/viscosity.h"
#include "FoamSim/dynamics/driven_air.h"
#include "FoamSim/dynamics/dynamics.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/direct.h"

namespace foamsim {

/// How the conservative scheme goes from step to step.
enum class Stepping {
  kick_drift,  ///< φ first, then positions with the new φ: one full evaluation and one of Ψ a step
  midpoint,    ///< implicit midpoint by fixed-point iteration
  rk4          ///< the classical Runge–Kutta method, four full evaluations
};

struct ConservativeOptions {
  Stepping stepping = Stepping::kick_drift;
  bool near_field = true;
  bool inertia = true;
  Tangential tangential = Tangential::smoothed;
  bool conserving_transfers = true;
  double viscosity = 0;         ///< η, surface viscosity over air density, L³/T
  double safety = 0.75;         ///< share of the longest stable step that is used
  double largest_strain = 0.4;  ///< change of an edge in a substep, as a share of its length
  Precision precision = Precision::automatic;
  long most_substeps = 16;        ///< a step is made in as many as these two ask for
  bool sheet_velocities = false;  ///< those that the sheet induces, as section 3 has them, not those of the forces
  bool correction = true;         ///< what is left of energy and impulse lost or won is given back; with kick_drift
};

/// Bound on the fixed-point iteration of Stepping::midpoint.
inline constexpr long most_midpoint_rounds = 30;

/// Films as a mechanical system (docs/method.md "A conservative scheme"): velocities are the adjoint of forces, so that
/// energy, volumes and equilibria are right on any mesh.
class Conservative final : public Dynamics {
 public:
  /// `sum`: how sums over the sheet are made, not null.
  explicit Conservative(const ConservativeOptions& options,
                        std::shared_ptr<const BiotSavart> sum = std::make_shared<DirectBiotSavart>())
      : options_(options), summation_(std::move(sum)) {
    if (options_.sheet_velocities) sheet_sum_.emplace(summation_);
  }

  double attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) override;
  /// What the first remeshing does to the area of a rough mesh is no motion: energy counts from behind it.
  bool remeshes_start() const override { return true; }
  /// At a free edge tension pulls along the film, and there is no air that would have to move for it.
  bool needs_held_edges() const override { return true; }
  /// `safety` of what the stiffest films bear, but no less than √(h̄³/tension)/4, about half of what regular triangles
  /// at a Plateau border do: shorter steps in a few places are left to substeps.
  double suitable_dt(const EffectStep& step, double tension) override;
  AirState air(const EffectStep& step, CirculationField& circulation) override;
  void before_burst(const EffectStep& step, CirculationField& circulation, lostopos::Region region) override;
  void after_burst(const EffectStep& step, CirculationField& circulation) override;
  void surface_changed(const AirState& before, const AirState& after, double films_energy) override;
  void advance(StepScope& scope, std::vector<lostopos::Vec3>& predicted) override;
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  using Positions = std::vector<lostopos::Vec3>;
  struct Rates {
    std::vector<double> phi;  // dφ/dt, by entry
    Positions x;              // dx/dt, by vertex slot
  };

  // A part of a step: where it begins after the step's start, and how long it is (T).
  struct Substep {
    StepScope& scope;
    double after, dt;
    LocalResponse& response;
  };

  void start(StepScope& scope);
  // φ of the films as they lie.
  void gather(const EffectStep& step, CirculationField& circulation);
  void drive(StepScope& scope);
  // What the drive has put into the air.
  void count_drive(StepScope& scope);
  // Tells of what flows through mouths in dt.
  void let_in(StepScope& scope, double dt, std::span<const double> flux) const;
  void begin_wires(StepScope& scope);
  // Whether wires drive vertices, and whether there are some with which the air has to go.
  bool drives() const { return driven_->acts() && !sheet_sum_; }
  bool drives_air() const { return driven_->takes_air() && !sheet_sum_; }
  // At the start of a step: φ_ for which the air goes with wires as they move now. Whether anything was changed.
  bool start_wires(StepScope& scope, std::span<const lostopos::Vec3> x);
  // The same within a kick, from φ_ to new_phi_; leaves change_ as that of the whole kick. Returns the wires' work.
  double hold_in_kick(StepScope& scope, std::span<const lostopos::Vec3> x);
  // The same for φ at a stage of other steppings.
  std::span<const double> held_at_stage(StepScope& scope, std::span<const lostopos::Vec3> x,
                                        std::span<const double> phi);
  // Work of moving what is held: counted, and known to the invariants.
  void count_work(StepScope& scope, double work);
  void count_surface_work(StepScope& scope, std::span<const lostopos::Vec3> x);
  void count_inertia_work(StepScope& scope, double dt, std::span<const lostopos::Vec3> x);
  long evaluations() const;
  // Rates of change at an instant after the step's start; leaves shape_, motion_ and force_ as they are there.
  void evaluate(StepScope& scope, double after, std::span<const lostopos::Vec3> x, std::span<const double> phi,
                Rates& rates);
  // Velocities of the vertices: by the fluxes, or by the sum over the sheet of φ.
  void move(StepScope& scope, std::span<const lostopos::Vec3> x, std::span<const double> phi,
            std::span<const double> flux, Positions& velocity);
  // dφ/dt of force_.
  void press(std::vector<double>& phi_rate);
  double longest_substep(StepScope& scope, std::span<const lostopos::Vec3> x, LocalResponse& response) const;
  // From φ and x to new φ and x, by rates that are evaluated; the first of a step measures.
  void substep(const Substep& step, Positions& x);
  void add_viscosity(const Substep& step);
  void kick_drift(const Substep& step, Positions& x);
  void midpoint(const Substep& step, Positions& x);
  void rk4(const Substep& step, Positions& x);
  void expect_kinetic_energy(double dt, std::span<const lostopos::Vec3> x, std::span<const double> flux);
  void take_back_remeshing(StepScope& scope);
  // The change of φ that gives back what energy and impulse the last step has lost or won, added to `phi`.
  void correct(StepScope& scope, std::vector<double>& phi);
  // Notes what the invariants were, half-way through a kick, and how far they are off.
  void remember(StepScope& scope, double energy, std::span<const double> phi);
  void report_state(StepScope& scope, double kinetic_energy, std::span<const double> phi) const;

  ConservativeOptions options_;
  double resolution_ = 0, delta_ = 0;
  std::optional<PotentialField> potential_;
  FilmConnectivity films_;
  FilmShape shape_;
  std::optional<Viscosity> viscosity_;
  NearField near_;
  std::optional<FilmMotion> motion_, change_;  // of φ, and of its change by a kick
  std::optional<DrivenAir> driven_;
  std::shared_ptr<const BiotSavart> summation_;
  std::optional<SheetVelocity> sheet_sum_;
  std::vector<SheetTriangle> sheet_;
  std::vector<double> phi_, new_phi_, stage_phi_, held_phi_, pressure_;
  std::vector<double> blown_;            // change of φ by what drives the air from outside; empty: nothing does
  std::optional<BurstPotential> burst_;  // between before_burst and after_burst
  Positions tangential_, force_, stage_x_;
  Rates rates_, sum_;
  std::optional<Invariants> kept_;                 // of the last step, what the next one has to have
  Invariants missing_;                             // what it had too little
  lostopos::Vec3 about_ = lostopos::Vec3::Zero();  // the point of the angular impulse, so that a shift changes nothing
  double expected_kinetic_ = 0;
  double slip_power_ = 0;      // of the last evaluation: forces that no pressure balances, times velocities
  double surface_energy_ = 0;  // of the positions that the last step predicted
  double wire_due_ = 0;        // work of wires that kept_ does not know of yet
};

}  // namespace foamsim
