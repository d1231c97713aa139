#include "MultiTracker/run/run_files.h"

#include <array>
#include <cstdio>

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "LosTopos/io/mesh_file.h"

namespace multitracker {

namespace fs = std::filesystem;

namespace {

struct Column {
  const char* name;
  double (*value)(const Metrics&);
};

constexpr std::array columns{
    Column{"step", [](const Metrics& m) { return static_cast<double>(m.step); }},
    Column{"time", [](const Metrics& m) { return m.time; }},
    Column{"vertices", [](const Metrics& m) { return static_cast<double>(m.vertices); }},
    Column{"triangles", [](const Metrics& m) { return static_cast<double>(m.triangles); }},
    Column{"regions", [](const Metrics& m) { return static_cast<double>(m.regions); }},
    Column{"area", [](const Metrics& m) { return m.area; }},
    Column{"shared_area", [](const Metrics& m) { return m.shared_area; }},
    Column{"air_area", [](const Metrics& m) { return m.air_area; }},
    Column{"junction_edges", [](const Metrics& m) { return static_cast<double>(m.junction_edges); }},
    Column{"volume_drift_max", [](const Metrics& m) { return m.volume_drift_max; }},
    Column{"motion_fraction", [](const Metrics& m) { return m.motion_fraction; }},
    Column{"snap_count", [](const Metrics& m) { return static_cast<double>(m.snaps); }},
    Column{"t1_count", [](const Metrics& m) { return static_cast<double>(m.separations); }},
    Column{"edge_merge_count", [](const Metrics& m) { return static_cast<double>(m.edge_merges); }},
    Column{"region_collapse_count", [](const Metrics& m) { return static_cast<double>(m.region_collapses); }},
    Column{"incomplete_vertices", [](const Metrics& m) { return static_cast<double>(m.incomplete_vertices); }},
    Column{"flow_seconds", [](const Metrics& m) { return m.flow_seconds; }},
    Column{"move_seconds", [](const Metrics& m) { return m.move_seconds; }},
    Column{"topology_seconds", [](const Metrics& m) { return m.topology_seconds; }},
    Column{"remesh_seconds", [](const Metrics& m) { return m.remesh_seconds; }},
};

std::string header() {
  std::string text;
  for (const Column& column : columns) text += (text.empty() ? "" : ",") + std::string(column.name);
  return text;
}

constexpr std::array run_files{"run.json", "metrics.csv", "volumes.csv", "events.csv", "frames"};

fs::path prepared(fs::path folder, bool force) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw base::InputError(folder.string() + " is a file; the output has to go to a folder");
  std::error_code error;
  for (const char* name : run_files) {
    if (!fs::exists(folder / name)) continue;
    if (!force)
      throw base::InputError(folder.string() + " already holds a run; give another --out, or --force to replace it");
    fs::remove_all(folder / name, error);
  }
  fs::create_directories(folder / "frames", error);
  if (error)
    throw base::FileError("cannot make the output folder " + folder.string() + ": " + error.message() +
                          "; give a folder that can be written to with --out");
  return folder;
}

}  // namespace

RunFiles::RunFiles(fs::path folder, bool force)
    : folder_(prepared(std::move(folder), force)),
      metrics_(folder_ / "metrics.csv", header()),
      volumes_(folder_ / "volumes.csv", "step,time,region,volume,faces,touches_air"),
      events_(folder_ / "events.csv", "step,time,kind,regions,x,y,z") {}

void RunFiles::write_step(const Tracking& tracking) {
  const Metrics& m = tracking.metrics();
  std::string row;
  for (const Column& column : columns) row += (row.empty() ? "" : ",") + base::to_text(column.value(m));
  metrics_.add(row + "\n");
  const std::string when = std::to_string(m.step) + "," + base::to_text(m.time) + ",";
  std::string rows;
  for (const RegionState& state : region_states(tracking.mesh()))
    rows += when + std::to_string(state.region.index()) + "," + base::to_text(state.volume) + "," +
            std::to_string(state.faces) + "," + (state.touches_air ? "1" : "0") + "\n";
  volumes_.add(rows);
  rows.clear();
  for (const lostopos::TopologyEvent& event : tracking.last().topology.events) {
    rows += when + name(event.kind) + ",";
    for (std::size_t i = 0; i < event.regions.size(); ++i)
      rows += (i == 0 ? "" : " ") + std::to_string(event.regions[i].index());
    for (double x : event.position) rows += "," + base::to_text(x);
    rows += "\n";
  }
  if (!rows.empty()) events_.add(rows);
}

void RunFiles::write_frame(const Tracking& tracking) {
  std::array<char, 40> file{};
  std::snprintf(file.data(), file.size(), "frame_%06ld.ply", tracking.metrics().step);
  fs::path frame = folder_ / "frames" / file.data();
  if (frame == last_frame_) return;
  lostopos::write_surface(frame, lostopos::from_mesh(tracking.mesh()));
  last_frame_ = std::move(frame);
}

}  // namespace multitracker
