#include "MultiTracker/run/metrics_csv.h"

#include <array>

#include "Base/io/csv_columns.h"

namespace multitracker {
namespace {

using base::cell_text;
using Column = base::CsvColumn<Metrics>;

constexpr std::array columns{
    Column{"step", [](const Metrics& m) { return cell_text(m.step); }},
    Column{"time", [](const Metrics& m) { return cell_text(m.time); }},
    Column{"vertices", [](const Metrics& m) { return cell_text(m.vertices); }},
    Column{"triangles", [](const Metrics& m) { return cell_text(m.triangles); }},
    Column{"regions", [](const Metrics& m) { return cell_text(m.regions); }},
    Column{"area", [](const Metrics& m) { return cell_text(m.area); }},
    Column{"shared_area", [](const Metrics& m) { return cell_text(m.shared_area); }},
    Column{"air_area", [](const Metrics& m) { return cell_text(m.air_area); }},
    Column{"junction_edges", [](const Metrics& m) { return cell_text(m.junction_edges); }},
    Column{"air_pockets", [](const Metrics& m) { return cell_text(m.air_pockets); }},
    Column{"air_tunnels", [](const Metrics& m) { return cell_text(m.air_tunnels); }},
    Column{"volume_drift_max", [](const Metrics& m) { return cell_text(m.volume_drift_max); }},
    Column{"motion_fraction", [](const Metrics& m) { return cell_text(m.motion_fraction); }},
    Column{"snap_count", [](const Metrics& m) { return cell_text(m.snaps); }},
    Column{"t1_count", [](const Metrics& m) { return cell_text(m.separations); }},
    Column{"edge_merge_count", [](const Metrics& m) { return cell_text(m.edge_merges); }},
    Column{"region_collapse_count", [](const Metrics& m) { return cell_text(m.region_collapses); }},
    Column{"incomplete_vertices", [](const Metrics& m) { return cell_text(m.incomplete_vertices); }},
    Column{"flow_seconds", [](const Metrics& m) { return cell_text(m.flow_seconds); }},
    Column{"move_seconds", [](const Metrics& m) { return cell_text(m.move_seconds); }},
    Column{"topology_seconds", [](const Metrics& m) { return cell_text(m.topology_seconds); }},
    Column{"remesh_seconds", [](const Metrics& m) { return cell_text(m.remesh_seconds); }},
};

}  // namespace

std::string metrics_header() {
  return base::csv_header<Metrics>(columns);
}

std::string metrics_row(const Metrics& metrics) {
  return base::csv_row<Metrics>(columns, metrics);
}

std::string volumes_header() {
  return "step,time,region,volume,faces,touches_air";
}

std::string volumes_rows(const Metrics& metrics, const lostopos::SurfaceMesh& mesh) {
  const std::string when = cell_text(metrics.step) + "," + cell_text(metrics.time) + ",";
  std::string rows;
  for (const RegionState& state : region_states(mesh))
    rows += when + std::to_string(state.region.index()) + "," + cell_text(state.volume) + "," +
            std::to_string(state.faces) + "," + (state.touches_air ? "1" : "0") + "\n";
  return rows;
}

}  // namespace multitracker
