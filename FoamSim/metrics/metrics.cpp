#include "FoamSim/metrics/metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "FoamSim/metrics/film_angles.h"
#include "FoamSim/metrics/junction_angles.h"

namespace foamsim {

using lostopos::RegionVolume;
using lostopos::Vec3;

double smallest_triangle_angle(const lostopos::SurfaceMesh& mesh) {
  // The cotangents of a triangle's corners are the dot products of the sides there over twice the area: no arc needs to
  // be taken but the last.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double greatest = -infinity;
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto [a, b, c] = lostopos::corners(mesh, t);
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double dot = std::max({-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)}), cross = ab.cross(bc).norm();
    greatest = std::max(greatest, cross > 0 ? dot / cross : infinity);
  }
  return std::atan2(1, greatest) * 180 / std::numbers::pi;
}

namespace {

void take_tracker_counts(const StepReport& report, Metrics& m) {
  using lostopos::Operation;
  m.times = report.times;
  m.move = report.move;
  m.remesh = report.remesh;
  m.stable_dt = report.stable_dt;
  m.substeps = report.substeps;
  m.viscosity_iterations = report.viscosity_iterations;
  m.correction = report.correction;
  m.tracker_surface_energy = report.tracker_surface_energy;
  m.tracker_kinetic_energy = report.tracker_kinetic_energy;
  m.move_energy = report.move_energy;
  m.topology_energy = report.topology_energy;
  m.remesh_energy = report.remesh_energy;
  m.topology_air_energy = report.topology_air_energy;
  m.remesh_air_energy = report.remesh_air_energy;
  m.midpoint_rounds = report.midpoint_rounds;
  m.effect_work = report.effect_work;
  m.wire_work = report.wire_work;
  m.wire_iterations = report.wire_iterations;
  m.implicit_iterations = report.implicit_iterations;
  m.motion_fraction = report.motion_fraction;
  m.splits = report.remesh[Operation::split].done;
  m.collapses = report.remesh[Operation::collapse].done;
  m.flips = report.remesh[Operation::flip].done;
  m.smoothings = report.remesh[Operation::smoothing].done;
  for (const lostopos::OperationCounts& counts : report.remesh.operations) m.refusals += counts.refused_in_all();
  m.collisions = report.move.collisions;
  m.impact_zones = report.move.inelastic_zones + report.move.rigid_zones;
  m.incomplete_vertices = report.topology.incomplete_vertices;
  m.topology_seconds = report.topology.seconds;
}

}  // namespace

Metrics measure(const Simulation& simulation, const StepReport& report,
                const std::vector<RegionVolume>& start_volumes) {
  const lostopos::SurfaceMesh& mesh = simulation.mesh();
  const JunctionAngles angles = junction_angles(mesh);
  const FilmAngles films = film_angles(mesh);
  Metrics m;
  m.step = simulation.steps();
  m.time = simulation.time();
  m.vertices = mesh.vertex_count();
  m.triangles = mesh.triangle_count();
  m.volumes = lostopos::closed_region_volumes(mesh);
  m.regions = lostopos::regions(mesh).size();
  m.area = simulation.geometry().total_area();
  m.kinetic_energy = report.kinetic_energy;
  m.potential_energy = report.potential_energy;
  m.energy = m.kinetic_energy + m.potential_energy;
  m.impulse = report.impulse;
  m.impulse_scale = report.impulse_scale;
  m.centroid = lostopos::surface_centroid(mesh);
  m.angle_rms_deg = angles.rms_deviation_deg;
  m.angle_outer_mean_deg = angles.outer_mean_deg;
  m.angle_rms_film_deg = films.rms_deviation_deg;
  m.angle_outer_mean_film_deg = films.outer_mean_deg;
  m.volume_drift_max = lostopos::largest_volume_drift(m.volumes, start_volumes);
  m.triangle_angle_min_deg = smallest_triangle_angle(mesh);
  m.topology_totals = simulation.topology_totals();
  m.velocity_evaluations = report.velocity_evaluations;
  take_tracker_counts(report, m);
  return m;
}

}  // namespace foamsim
