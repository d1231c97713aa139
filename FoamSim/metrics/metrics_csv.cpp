#include "FoamSim/metrics/metrics_csv.h"

#include <vector>

#include "Base/io/csv_columns.h"

namespace foamsim {

using lostopos::Operation;

namespace {

using base::cell_text;
using Column = base::CsvColumn<Metrics>;

// These twenty in this order are a promise to readers of the file; more may follow.
std::vector<Column> promised_columns() {
  return {
      {"step", [](const Metrics& m) { return cell_text(m.step); }},
      {"time", [](const Metrics& m) { return cell_text(m.time); }},
      {"vertices", [](const Metrics& m) { return cell_text(m.vertices); }},
      {"triangles", [](const Metrics& m) { return cell_text(m.triangles); }},
      {"regions", [](const Metrics& m) { return cell_text(m.regions); }},
      {"area", [](const Metrics& m) { return cell_text(m.area); }},
      {"energy", [](const Metrics& m) { return cell_text(m.energy); }},
      {"impulse_x", [](const Metrics& m) { return cell_text(m.impulse.x()); }},
      {"impulse_y", [](const Metrics& m) { return cell_text(m.impulse.y()); }},
      {"impulse_z", [](const Metrics& m) { return cell_text(m.impulse.z()); }},
      {"centroid_x", [](const Metrics& m) { return cell_text(m.centroid.x()); }},
      {"centroid_y", [](const Metrics& m) { return cell_text(m.centroid.y()); }},
      {"centroid_z", [](const Metrics& m) { return cell_text(m.centroid.z()); }},
      {"angle_rms_deg", [](const Metrics& m) { return cell_text(m.angle_rms_deg); }},
      {"angle_outer_mean_deg", [](const Metrics& m) { return cell_text(m.angle_outer_mean_deg); }},
      {"volume_drift_max", [](const Metrics& m) { return cell_text(m.volume_drift_max); }},
      {"triangle_angle_min_deg", [](const Metrics& m) { return cell_text(m.triangle_angle_min_deg); }},
      {"t1_count", [](const Metrics& m) { return cell_text(m.topology_totals.separations); }},
      {"snap_count", [](const Metrics& m) { return cell_text(m.topology_totals.snaps); }},
      {"step_seconds", [](const Metrics& m) { return cell_text(m.step_seconds); }},
  };
}

std::vector<Column> work_columns() {
  return {
      {"kinetic_energy", [](const Metrics& m) { return cell_text(m.kinetic_energy); }},
      {"potential_energy", [](const Metrics& m) { return cell_text(m.potential_energy); }},
      {"impulse_scale", [](const Metrics& m) { return cell_text(m.impulse_scale); }},
      {"velocity_evaluations", [](const Metrics& m) { return cell_text(m.velocity_evaluations); }},
      {"motion_fraction", [](const Metrics& m) { return cell_text(m.motion_fraction); }},
      {"splits", [](const Metrics& m) { return cell_text(m.splits); }},
      {"collapses", [](const Metrics& m) { return cell_text(m.collapses); }},
      {"flips", [](const Metrics& m) { return cell_text(m.flips); }},
      {"smoothings", [](const Metrics& m) { return cell_text(m.smoothings); }},
      {"refusals", [](const Metrics& m) { return cell_text(m.refusals); }},
      {"collisions", [](const Metrics& m) { return cell_text(m.collisions); }},
      {"impact_zones", [](const Metrics& m) { return cell_text(m.impact_zones); }},
      {"velocity_seconds", [](const Metrics& m) { return cell_text(m.times.seconds("velocity")); }},
      {"move_seconds", [](const Metrics& m) { return cell_text(m.times.seconds("move")); }},
      {"broad_phase_seconds", [](const Metrics& m) { return cell_text(m.move.broad_phase_seconds); }},
      {"ccd_seconds", [](const Metrics& m) { return cell_text(m.move.ccd_seconds); }},
      {"impulse_seconds", [](const Metrics& m) { return cell_text(m.move.impulse_seconds); }},
      {"zone_seconds", [](const Metrics& m) { return cell_text(m.move.zone_seconds); }},
      {"remesh_seconds", [](const Metrics& m) { return cell_text(m.times.seconds("remesh")); }},
      {"split_seconds", [](const Metrics& m) { return cell_text(m.remesh[Operation::split].seconds); }},
      {"collapse_seconds", [](const Metrics& m) { return cell_text(m.remesh[Operation::collapse].seconds); }},
      {"flip_seconds", [](const Metrics& m) { return cell_text(m.remesh[Operation::flip].seconds); }},
      {"smoothing_seconds", [](const Metrics& m) { return cell_text(m.remesh[Operation::smoothing].seconds); }},
      {"angle_rms_film_deg", [](const Metrics& m) { return cell_text(m.angle_rms_film_deg); }},
      {"angle_outer_mean_film_deg", [](const Metrics& m) { return cell_text(m.angle_outer_mean_film_deg); }},
      {"edge_merges", [](const Metrics& m) { return cell_text(m.topology_totals.edge_merges); }},
      {"region_collapses", [](const Metrics& m) { return cell_text(m.topology_totals.region_collapses); }},
      {"cancelled_triangles", [](const Metrics& m) { return cell_text(m.topology_totals.cancelled_triangles); }},
      {"incomplete_vertices", [](const Metrics& m) { return cell_text(m.incomplete_vertices); }},
      {"topology_seconds", [](const Metrics& m) { return cell_text(m.topology_seconds); }},
  };
}

std::vector<Column> energy_columns() {
  return {
      {"stable_dt", [](const Metrics& m) { return cell_text(m.stable_dt); }},
      {"substeps", [](const Metrics& m) { return cell_text(m.substeps); }},
      {"viscosity_iterations", [](const Metrics& m) { return cell_text(m.viscosity_iterations); }},
      {"correction", [](const Metrics& m) { return cell_text(m.correction); }},
      {"tracker_surface_energy", [](const Metrics& m) { return cell_text(m.tracker_surface_energy); }},
      {"tracker_kinetic_energy", [](const Metrics& m) { return cell_text(m.tracker_kinetic_energy); }},
      {"move_energy", [](const Metrics& m) { return cell_text(m.move_energy); }},
      {"topology_energy", [](const Metrics& m) { return cell_text(m.topology_energy); }},
      {"remesh_energy", [](const Metrics& m) { return cell_text(m.remesh_energy); }},
      {"topology_air_energy", [](const Metrics& m) { return cell_text(m.topology_air_energy); }},
      {"remesh_air_energy", [](const Metrics& m) { return cell_text(m.remesh_air_energy); }},
      {"midpoint_rounds", [](const Metrics& m) { return cell_text(m.midpoint_rounds); }},
      {"effect_work", [](const Metrics& m) { return cell_text(m.effect_work); }},
      {"wire_work", [](const Metrics& m) { return cell_text(m.wire_work); }},
      {"wire_iterations", [](const Metrics& m) { return cell_text(m.wire_iterations); }},
      {"implicit_iterations", [](const Metrics& m) { return cell_text(m.implicit_iterations); }},
  };
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = [] {
    std::vector<Column> columns = promised_columns();
    for (const auto& more : {work_columns(), energy_columns()}) columns.insert(columns.end(), more.begin(), more.end());
    return columns;
  }();
  return all;
}

}  // namespace

std::string metrics_header() {
  return base::csv_header<Metrics>(columns());
}

std::string metrics_row(const Metrics& metrics) {
  return base::csv_row<Metrics>(columns(), metrics);
}

std::string volumes_header() {
  return "step,region,volume";
}

std::string volumes_rows(const Metrics& metrics) {
  std::string rows;
  for (const auto& [region, volume] : metrics.volumes)
    rows += std::to_string(metrics.step) + "," + std::to_string(region.index()) + "," + cell_text(volume) + "\n";
  return rows;
}

}  // namespace foamsim
