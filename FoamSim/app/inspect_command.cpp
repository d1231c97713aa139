#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/metrics/film_angles.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/metrics/metrics.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/repair/repair_surface.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim::app {

using nlohmann::ordered_json;

namespace {

ordered_json inspect(const std::string& file, const lostopos::SurfaceData& surface) {
  const lostopos::SurfaceMesh mesh = lostopos::to_mesh(surface);
  const JunctionAngles angles = junction_angles(mesh);
  const FilmAngles films = film_angles(mesh);
  const lostopos::AuditReport audit = lostopos::audit(mesh);
  ordered_json volumes = ordered_json::object();
  for (const auto& [region, volume] : lostopos::region_volumes(mesh)) volumes[std::to_string(region.index())] = volume;
  ordered_json findings = ordered_json::array();
  for (const lostopos::Finding& finding : audit.findings)
    findings.push_back(std::string(name(finding.defect)) + ": " + finding.message);
  const lostopos::Vec3 centroid = lostopos::surface_centroid(mesh);
  ordered_json report{{"file", file},
                      {"vertices", mesh.vertex_count()},
                      {"edges", mesh.edge_count()},
                      {"triangles", mesh.triangle_count()},
                      {"euler_characteristic", lostopos::euler_characteristic(mesh)},
                      {"junction_edges", lostopos::junction_edge_count(mesh)},
                      {"open_edges", lostopos::open_edge_count(mesh)},
                      {"area", lostopos::total_area(mesh)},
                      {"mean_edge_length", lostopos::mean_edge_length(mesh)},
                      {"triangle_angle_min_deg", smallest_triangle_angle(mesh)},
                      {"centroid", {centroid.x(), centroid.y(), centroid.z()}},
                      {"volumes", volumes},
                      {"angle_rms_deg", nullptr},
                      {"angle_outer_mean_deg", nullptr},
                      {"angle_rms_film_deg", nullptr},
                      {"angle_outer_mean_film_deg", nullptr},
                      {"audit", audit.clean() ? "clean" : "not clean"},
                      {"findings", findings}};
  if (angles.rms_deviation_deg) report["angle_rms_deg"] = *angles.rms_deviation_deg;
  if (angles.outer_mean_deg) report["angle_outer_mean_deg"] = *angles.outer_mean_deg;
  if (films.rms_deviation_deg) report["angle_rms_film_deg"] = *films.rms_deviation_deg;
  if (films.outer_mean_deg) report["angle_outer_mean_film_deg"] = *films.outer_mean_deg;
  return report;
}

// Writes the mended surface, and tells of it in the report.
ordered_json repair(const std::string& file, const std::string& out) {
  if (lostopos::find_mesh_format(out) == nullptr)
    throw base::InputError("--repair " + out + ": no mesh file is called so; known are " + lostopos::mesh_extensions());
  lostopos::SurfaceData surface = lostopos::read_surface(file);
  const lostopos::RepairReport done = lostopos::repair_surface(surface);
  lostopos::write_surface(out, surface);
  ordered_json report = inspect(out, surface);
  report["repaired"] = done.done;
  report["findings"] = done.left;  // the same, with what would help
  return report;
}

void print_inspection(const ordered_json& report) {
  for (const auto& [key, value] : report.items()) {
    if (key == "volumes") {
      for (const auto& [region, volume] : value.items())
        std::printf("volume of region %-6s %s\n", region.c_str(), volume.dump().c_str());
    } else if (key == "findings" || key == "repaired") {
      if (key == "repaired") std::printf("repaired%s\n", value.empty() ? ": there was nothing to mend" : "");
      for (const auto& finding : value) std::printf("  %s\n", finding.get<std::string>().c_str());
    } else if (!value.is_null()) {
      std::printf("%-23s %s\n", key.c_str(), (value.is_string() ? value.get<std::string>() : value.dump()).c_str());
    }
  }
}

}  // namespace

void add_inspect_command(base::Command& root, const Program&) {
  base::Command& command = root.add_command(
      "inspect", "counts, areas, volumes, angles and an audit of a mesh file; exit code 2 when it is not clean");
  auto file = std::make_shared<std::string>();
  auto repaired = std::make_shared<std::string>();
  auto as_json = std::make_shared<bool>(false);
  command.add({.name = "file",
               .target = file.get(),
               .help = "mesh file (" + lostopos::mesh_extensions() + ")",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.add({.name = "--repair",
               .target = repaired.get(),
               .help = "mend what can be mended, write the surface to this file, and inspect that",
               .offers = base::Argument::Offers::files});
  command.add({.name = "--json", .target = as_json.get(), .help = "as JSON"});
  command.set_action([file, repaired, as_json] {
    const ordered_json report =
        repaired->empty() ? inspect(*file, lostopos::read_surface(*file)) : repair(*file, *repaired);
    if (*as_json)
      std::printf("%s\n", report.dump(2).c_str());
    else
      print_inspection(report);
    return report.at("findings").empty() ? exit_done : exit_bad_input;
  });
}

}  // namespace foamsim::app
