#include "FoamSim/run/start_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/tidy_surface.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

constexpr std::size_t most_findings = 3;

std::string text_of(const lostopos::AuditReport& report) {
  std::string text;
  for (const lostopos::Finding& finding : report.findings)
    text += (text.empty() ? "" : "; ") + std::string(name(finding.defect)) + ": " + finding.message;
  return text + (report.truncated ? "; and more ('foamsim inspect' lists them)" : "");
}

void look_for_open_edges(const Scene& scene, const Simulation& simulation, std::vector<std::string>& notes) {
  if (start_file(scene).empty()) return;
  const std::size_t open = lostopos::open_edge_count(simulation.mesh());
  if (open > 0)
    notes.push_back("the surface has " + std::to_string(open) +
                    " open edges; films are held there, as at a frame, and regions that end there have no volume");
}

// What reading the file has mended.
void look_at_file(const Scene& scene, std::vector<std::string>& notes) {
  const std::string file = start_file(scene);
  if (file.empty()) return;
  lostopos::SurfaceData data = lostopos::read_surface(file);
  for (std::string& note : lostopos::tidy_surface(data)) notes.push_back(std::move(note));
}

void require_carried(const Scene& scene, const Simulation& simulation, const StartOfRun& start,
                     std::vector<std::string>& notes) {
  if (!simulation.options().tracker.remeshing) return;
  const lostopos::RegionVolume* smallest = nullptr;
  for (const lostopos::RegionVolume& v : start.volumes)
    if (v.region != lostopos::air && v.volume > 0 && (smallest == nullptr || v.volume < smallest->volume))
      smallest = &v;
  if (smallest == nullptr) return;
  const double radius = std::cbrt(3 * smallest->volume / (4 * std::numbers::pi));
  if (!(simulation.resolution() > radius)) return;
  const std::string problem = "the resolution " + base::to_text(simulation.resolution()) +
                              " is more than the smallest bubble can carry (region " +
                              std::to_string(smallest->region.index()) + ", of a radius of " + base::to_text(radius) +
                              "): remeshing would take it away";
  if (scene.options.number("resolution") > 0)
    throw base::InputError(problem + "; give a resolution of at most " + base::to_text(radius) +
                           ", a quarter of that to see its shape");
  notes.push_back(problem + "; a resolution of less keeps it");
}

}  // namespace

// Free edges are where films end at a frame: no defect here.
std::vector<std::string> check_surface(const Simulation& simulation) {
  using lostopos::Defect;
  const auto report = lostopos::audit(simulation.mesh(), {.closed_regions = false, .max_findings = most_findings});
  for (Defect defect : {Defect::broken_incidence, Defect::bad_labels, Defect::not_finite})
    if (report.has(defect)) throw base::InputError("the surface cannot be simulated: " + text_of(report));
  if (report.clean()) return {};
  return {"the surface is not clean: " + text_of(report)};
}

std::vector<std::string> check_start(const Scene& scene, const Simulation& simulation, const StartOfRun& start) {
  std::vector<std::string> notes;
  if (scene.mesh_file.empty())
    if (const auto& of_scene = scene.catalogue->scenes.find(scene.name).notes) notes = of_scene(scene.options);
  look_at_file(scene, notes);
  for (std::string& note : check_surface(simulation)) notes.push_back(std::move(note));
  look_for_open_edges(scene, simulation, notes);
  require_carried(scene, simulation, start, notes);
  return notes;
}

}  // namespace foamsim
