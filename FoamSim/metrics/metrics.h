#pragma once

#include <optional>
#include <vector>

#include "FoamSim/dynamics/simulation.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

/// One row of metrics.csv: the surface after a step, and what the step reported.
struct Metrics {
  long step = 0;
  double time = 0;  ///< T
  std::size_t vertices = 0, triangles = 0, regions = 0;
  double area = 0;    ///< L²
  double energy = 0;  ///< kinetic + potential at the step's velocity evaluation (StepReport), L⁵/T²
  double kinetic_energy = 0, potential_energy = 0;
  lostopos::Vec3 impulse = lostopos::Vec3::Zero();   ///< L⁴/T
  double impulse_scale = 0;                          ///< Σ|2Γ̄ area|, L⁴/T
  lostopos::Vec3 centroid = lostopos::Vec3::Zero();  ///< area-weighted over films, L
  std::optional<double> angle_rms_deg, angle_outer_mean_deg;
  double volume_drift_max = 0;                                          ///< see lostopos::largest_volume_drift
  double triangle_angle_min_deg = 0;                                    ///< smallest corner angle of any triangle
  std::optional<double> angle_rms_film_deg, angle_outer_mean_film_deg;  ///< see FilmAngles
  TopologyTotals topology_totals;                                       ///< since the start
  std::size_t incomplete_vertices = 0;  ///< where two regions meet without a common film, after the step
  double topology_seconds = 0;          ///< wall time of the step's topology passes
  double step_seconds = 0;              ///< wall time of the step, without its measurement
  long velocity_evaluations = 0;        ///< in the step
  double stable_dt = 0;                 ///< of the conservative scheme, see StepReport, T
  long substeps = 1;
  long viscosity_iterations = 0;
  double correction = 0;
  double tracker_surface_energy = 0, tracker_kinetic_energy = 0;   ///< L⁵/T²
  double move_energy = 0, topology_energy = 0, remesh_energy = 0;  ///< see StepReport, L⁵/T²
  std::optional<double> topology_air_energy, remesh_air_energy;    ///< see StepReport, L⁵/T²
  long midpoint_rounds = 0;
  double effect_work = 0, wire_work = 0;  ///< see StepReport, L⁵/T²
  long wire_iterations = 0;
  long implicit_iterations = 0;  ///< of the integrators implicit and pbd
  double motion_fraction = 1;    ///< of the predicted motion that the tracker could do
  /// In the step: remeshing operations done, refused in all, collisions answered.
  std::size_t splits = 0, collapses = 0, flips = 0, smoothings = 0, refusals = 0;
  std::size_t collisions = 0, impact_zones = 0;
  base::StageTimes times;                       ///< wall seconds of the step by stage
  lostopos::MoveStatistics move;                ///< for the seconds within the move
  lostopos::RemeshStatistics remesh;            ///< for the seconds of each operation
  std::vector<lostopos::RegionVolume> volumes;  ///< L³, for volumes.csv
};

/// Measures the simulation's surface after a step; its `step_seconds` are for who timed it to say. `start_volumes`:
/// closed_region_volumes at the start of the run.
Metrics measure(const Simulation& simulation, const StepReport& report,
                const std::vector<lostopos::RegionVolume>& start_volumes);

/// Smallest corner angle of all triangles, degrees.
double smallest_triangle_angle(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
