#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "FoamSim/constraints/constraint.h"
#include "FoamSim/dynamics/dynamics.h"
#include "FoamSim/dynamics/simulation_state.h"
#include "FoamSim/effects/effect.h"
#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/vertex_ids.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

struct SimulationOptions {
  double dt = 0.01;       ///< length of a step, T; 0: what the dynamics choose for the start surface
  double delta = 0;       ///< regularisation δ, L; 0: what the dynamics choose
  double resolution = 0;  ///< target mean edge length h̄, L; 0: the mean over the start mesh's edges
  /// Measure the air's energy after move, topology and remeshing of every step: three sums over all pairs.
  bool air_by_stage = false;
  /// Number the vertices for as long as they live (the attribute "vertex_id"), and keep how far the last step moved
  /// each (the attribute "motion", L).
  bool follow_vertices = false;
  /// How the surface is moved and remeshed; its resolution is set to h̄. Nothing is remeshed unless it says so.
  lostopos::TrackerOptions tracker = {.remeshing = false};
};

/// What a simulation is made of besides its surface: each chosen by whoever makes it.
struct SimulationParts {
  std::vector<std::unique_ptr<Effect>> effects = {};          ///< act in this order
  std::vector<std::unique_ptr<Constraint>> constraints = {};  ///< act after them, in this order
  std::unique_ptr<Dynamics> dynamics = {};                    ///< not null
};

/// h̄: options.resolution, or the mean over the mesh's edges where that is 0.
double resolved_resolution(const SimulationOptions& options, const lostopos::SurfaceMesh& mesh);

/// Soap films on a tracked surface: what acts on them, how they move, and the surface that follows: docs/method.md "The
/// step".
class Simulation {
 public:
  /// Starts at rest (Γ = 0), at time 0. Values that wait in the mesh ("hold", "solid", "circulation") are taken. Throws
  /// base::InputError for a mesh without triangles, options out of range, parts that are missing, or a dt that is left
  /// to dynamics which cannot choose one.
  Simulation(lostopos::SurfaceMesh mesh, const SimulationOptions& options, SimulationParts parts);

  /// One step of dt: effects and constraints on Γ, velocity, predicted positions, the tracker's move, topology and
  /// remeshing. Throws lostopos::MotionError when the surface cannot be moved, and whatever an effect throws; the whole
  /// state is then the one before the step, to the bit.
  StepReport step();

  const lostopos::SurfaceMesh& mesh() const { return tracker_->mesh(); }
  const CirculationField& circulation() const { return *circulation_; }
  CirculationField& circulation() { return *circulation_; }
  /// By vertex slot: what is held of each, see lostopos/mesh/hold.h.
  std::span<const lostopos::Hold> held() const;
  /// By triangle slot: not zero for those of a solid.
  std::span<const std::uint8_t> solid() const;
  /// Areas, angles and region lists of the surface as it is now.
  const SurfaceGeometry& geometry() const { return geometry_; }
  const std::vector<std::unique_ptr<Effect>>& effects() const { return parts_.effects; }
  const std::vector<std::unique_ptr<Constraint>>& constraints() const { return parts_.constraints; }
  /// With dt as it is used.
  const SimulationOptions& options() const { return options_; }
  double resolution() const { return resolution_; }
  double delta() const { return delta_; }
  long steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * options_.dt; }
  /// Sum of the effects' potential energies of the surface as it is now.
  double potential_energy() const;
  const TopologyTotals& topology_totals() const { return topology_totals_; }

  /// @name State
  ///@{
  SimulationState state() const;
  /// The same into one that is there, whose memory is used again.
  void save(SimulationState& state) const;
  /// Puts everything back. Throws base::InputError when the state is one of other effects or constraints.
  void restore(const SimulationState& state);
  ///@}

 private:
  StepReport make_step();
  void change_surface(StepReport& report);
  void burst(lostopos::Region region, StepReport& report);
  void displace(std::span<const lostopos::Vec3> positions, StepReport& report);
  void count_work(const AirState& before, double films_before, StepReport& report);
  EffectStep effect_step() const;
  void track(StepReport& report);
  double air_energy();
  void remesh_start();
  double chosen_dt() const;
  double settle(StepReport& report);
  double tension() const;

  SimulationOptions options_;
  std::unique_ptr<lostopos::SurfaceTracker> tracker_;
  std::unique_ptr<CirculationField> circulation_;
  std::optional<lostopos::VertexIds> vertex_ids_;
  SimulationParts parts_;
  SurfaceGeometry geometry_;
  std::vector<lostopos::Vec3> predicted_;
  double resolution_ = 0, delta_ = 0;
  long steps_ = 0;
  TopologyTotals topology_totals_;
  SimulationState before_;  ///< the step that is being made
};

}  // namespace foamsim
