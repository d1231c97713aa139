#include "FoamSim/studies/reproduce/scene_gallery.h"

#include <cmath>
#include <ctime>

#include "Base/io/atomic_file.h"
#include "Base/options/option_value.h"

namespace foamsim {
namespace {

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

bool GalleryRow::holds() const {
  return std::abs(measured - expected) <= tolerance * std::abs(expected);
}

std::vector<GalleryRow> run_gallery_scene(const GalleryScene& scene, const GalleryHooks& hooks) {
  Scene asked = built_in_scene(scene.scene);
  for (const std::string& assignment : scene.assignments) asked.options.set_assignment(assignment, scene.scene);
  const double begin = cpu_seconds();
  Simulation simulation = make_simulation(asked);
  std::vector<GalleryRow> rows;
  const double half_a_step = 0.5 * asked.options.number("dt");
  std::vector<GalleryFigure> to_come = scene.figures;
  while (simulation.time() < scene.time - half_a_step) {
    if (hooks.interrupted && hooks.interrupted()) return rows;
    simulation.step();
    if (hooks.stepped) hooks.stepped(simulation, simulation.time() / scene.time);
    std::erase_if(to_come, [&](const GalleryFigure& f) {
      if (simulation.time() < f.time - half_a_step) return false;
      rows.push_back({scene.scene, f.quantity, simulation.time(), f.of(simulation), f.expected, f.tolerance, f.source,
                      cpu_seconds() - begin});
      return true;
    });
  }
  if (hooks.picture) hooks.picture(simulation);
  return rows;
}

void write_gallery(const std::filesystem::path& file, const std::vector<GalleryRow>& rows) {
  base::AtomicFile csv(file);
  csv.stream() << "scene,quantity,time,measured,expected,tolerance,source,cpu_seconds\n";
  for (const GalleryRow& r : rows) {
    csv.stream() << r.scene << ',' << r.quantity << ',' << base::to_text(r.time) << ',' << base::to_text(r.measured)
                 << ',' << base::to_text(r.expected) << ',' << base::to_text(r.tolerance) << ',' << r.source << ','
                 << base::to_text(r.cpu_seconds) << '\n';
  }
  csv.commit();
}

}  // namespace foamsim
