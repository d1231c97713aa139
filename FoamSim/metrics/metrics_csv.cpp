#include "FoamSim/metrics/metrics_csv.h"

#include <functional>
#include <utility>
#include <vector>

#include "Base/options/option_value.h"

namespace foamsim {

using lostopos::Operation;

namespace {

struct Column {
  const char* name;
  std::string (*text)(const Metrics&);
};

std::string text(double number) {
  return base::to_text(number);
}
std::string text(long number) {
  return std::to_string(number);
}
std::string text(std::size_t number) {
  return std::to_string(number);
}
std::string text(const std::optional<double>& number) {
  return number ? base::to_text(*number) : std::string();
}

// The first twenty in this order are a promise to readers of the file; more may follow.
const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"step", [](const Metrics& m) { return text(m.step); }},
      {"time", [](const Metrics& m) { return text(m.time); }},
      {"vertices", [](const Metrics& m) { return text(m.vertices); }},
      {"triangles", [](const Metrics& m) { return text(m.triangles); }},
      {"regions", [](const Metrics& m) { return text(m.regions); }},
      {"area", [](const Metrics& m) { return text(m.area); }},
      {"energy", [](const Metrics& m) { return text(m.energy); }},
      {"impulse_x", [](const Metrics& m) { return text(m.impulse.x()); }},
      {"impulse_y", [](const Metrics& m) { return text(m.impulse.y()); }},
      {"impulse_z", [](const Metrics& m) { return text(m.impulse.z()); }},
      {"centroid_x", [](const Metrics& m) { return text(m.centroid.x()); }},
      {"centroid_y", [](const Metrics& m) { return text(m.centroid.y()); }},
      {"centroid_z", [](const Metrics& m) { return text(m.centroid.z()); }},
      {"angle_rms_deg", [](const Metrics& m) { return text(m.angle_rms_deg); }},
      {"angle_outer_mean_deg", [](const Metrics& m) { return text(m.angle_outer_mean_deg); }},
      {"volume_drift_max", [](const Metrics& m) { return text(m.volume_drift_max); }},
      {"triangle_angle_min_deg", [](const Metrics& m) { return text(m.triangle_angle_min_deg); }},
      {"t1_count", [](const Metrics& m) { return text(m.topology_totals.separations); }},
      {"snap_count", [](const Metrics& m) { return text(m.topology_totals.snaps); }},
      {"step_seconds", [](const Metrics& m) { return text(m.step_seconds); }},
      {"kinetic_energy", [](const Metrics& m) { return text(m.kinetic_energy); }},
      {"potential_energy", [](const Metrics& m) { return text(m.potential_energy); }},
      {"impulse_scale", [](const Metrics& m) { return text(m.impulse_scale); }},
      {"velocity_evaluations", [](const Metrics& m) { return text(m.velocity_evaluations); }},
      {"motion_fraction", [](const Metrics& m) { return text(m.motion_fraction); }},
      {"splits", [](const Metrics& m) { return text(m.splits); }},
      {"collapses", [](const Metrics& m) { return text(m.collapses); }},
      {"flips", [](const Metrics& m) { return text(m.flips); }},
      {"smoothings", [](const Metrics& m) { return text(m.smoothings); }},
      {"refusals", [](const Metrics& m) { return text(m.refusals); }},
      {"collisions", [](const Metrics& m) { return text(m.collisions); }},
      {"impact_zones", [](const Metrics& m) { return text(m.impact_zones); }},
      {"velocity_seconds", [](const Metrics& m) { return text(m.times.seconds("velocity")); }},
      {"move_seconds", [](const Metrics& m) { return text(m.times.seconds("move")); }},
      {"broad_phase_seconds", [](const Metrics& m) { return text(m.move.broad_phase_seconds); }},
      {"ccd_seconds", [](const Metrics& m) { return text(m.move.ccd_seconds); }},
      {"impulse_seconds", [](const Metrics& m) { return text(m.move.impulse_seconds); }},
      {"zone_seconds", [](const Metrics& m) { return text(m.move.zone_seconds); }},
      {"remesh_seconds", [](const Metrics& m) { return text(m.times.seconds("remesh")); }},
      {"split_seconds", [](const Metrics& m) { return text(m.remesh[Operation::split].seconds); }},
      {"collapse_seconds", [](const Metrics& m) { return text(m.remesh[Operation::collapse].seconds); }},
      {"flip_seconds", [](const Metrics& m) { return text(m.remesh[Operation::flip].seconds); }},
      {"smoothing_seconds", [](const Metrics& m) { return text(m.remesh[Operation::smoothing].seconds); }},
      {"angle_rms_film_deg", [](const Metrics& m) { return text(m.angle_rms_film_deg); }},
      {"angle_outer_mean_film_deg", [](const Metrics& m) { return text(m.angle_outer_mean_film_deg); }},
      {"edge_merges", [](const Metrics& m) { return text(m.topology_totals.edge_merges); }},
      {"region_collapses", [](const Metrics& m) { return text(m.topology_totals.region_collapses); }},
      {"cancelled_triangles", [](const Metrics& m) { return text(m.topology_totals.cancelled_triangles); }},
      {"incomplete_vertices", [](const Metrics& m) { return text(m.incomplete_vertices); }},
      {"topology_seconds", [](const Metrics& m) { return text(m.topology_seconds); }},
  };
  return all;
}

}  // namespace

std::string metrics_header() {
  std::string header;
  for (const Column& column : columns()) header += (header.empty() ? "" : ",") + std::string(column.name);
  return header;
}

std::string metrics_row(const Metrics& metrics) {
  std::string row;
  for (const Column& column : columns()) row += (&column == &columns().front() ? "" : ",") + column.text(metrics);
  return row + "\n";
}

std::string volumes_header() {
  return "step,region,volume";
}

std::string volumes_rows(const Metrics& metrics) {
  std::string rows;
  for (const auto& [region, volume] : metrics.volumes)
    rows += text(metrics.step) + "," + std::to_string(region.index()) + "," + text(volume) + "\n";
  return rows;
}

}  // namespace foamsim
