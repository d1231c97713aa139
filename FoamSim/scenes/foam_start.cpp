#include "FoamSim/scenes/foam_start.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace foamsim {

namespace fs = std::filesystem;

lostopos::SurfaceMesh grown_foam(long spheres, std::uint64_t seed) {
  constexpr int steps = 25;
  Scene scene = built_in_scene("growth");
  scene.options.set("spheres", spheres, "");
  scene.options.set("seed", static_cast<long>(seed), "");
  scene.options.set("resolution", 0.15, "");
  scene.options.set("dt", 0.02, "");
  Simulation simulation = make_simulation(scene);
  for (int i = 0; i < steps; ++i) simulation.step();
  // Without attributes: at rest, nothing held.
  return lostopos::to_mesh(lostopos::from_mesh(simulation.mesh()));
}

lostopos::SurfaceMesh voronoi_bubbles(long bubbles, int relaxations, std::uint64_t seed) {
  constexpr double volume = std::numbers::pi / 6;
  lostopos::SurfaceMesh mesh =
      lostopos::voronoi_foam({.cells = bubbles, .seed = seed, .relaxations = relaxations, .subdivisions = 1});
  const double side = std::cbrt(volume * static_cast<double>(bubbles));
  for (lostopos::Vertex v : mesh.vertices()) mesh.set_position(v, side * mesh.position(v));
  return mesh;
}

std::string path_of_mesh(const std::string& folder, const std::string& file) {
  const std::string wanted = "load_dir has to be the folder of a run of the reference program, with its " + file;
  if (folder.empty()) throw base::InputError(wanted + "; it is not set");
  const fs::path path = fs::path(folder) / file;
  if (!fs::is_directory(folder)) throw base::InputError(wanted + "; there is no folder '" + folder + "'");
  if (!fs::is_regular_file(path)) throw base::InputError(wanted + "; '" + folder + "' has no such file");
  return path.string();
}

lostopos::SurfaceMesh mesh_of_run(const std::string& folder, const std::string& file) {
  return lostopos::to_mesh(lostopos::read_surface(path_of_mesh(folder, file)));
}

}  // namespace foamsim
