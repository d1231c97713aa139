#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// A number that a scene is known by: measured at a time, beside what it should be.
struct GalleryFigure {
  std::string quantity;
  double time = 0;  ///< T
  std::function<double(const Simulation& simulation)> of;
  double expected = 0;
  double tolerance = 0;  ///< relative to `expected`
  std::string source;    ///< of the expected value: "reference program", "closed form", …
};

/// A built-in scene as docs/scenes.md shows it.
struct GalleryScene {
  std::string scene;
  double time = 0;                       ///< of its picture, T; not before the last figure
  std::vector<std::string> assignments;  ///< as after --set
  std::vector<GalleryFigure> figures;
  std::array<double, 3> view{0.514, 0.242, 0.823};  ///< from the films to the eye
};

/// All built-in scenes but `load`, which needs a mesh.
std::vector<GalleryScene> gallery_scenes();

/// One row of scenes.csv.
struct GalleryRow {
  std::string scene, quantity;
  double time = 0, measured = 0, expected = 0, tolerance = 0;
  std::string source;
  double cpu_seconds = 0;  ///< until then
  bool holds() const;
};

struct GalleryHooks {
  std::function<void(const Simulation&, double fraction)> stepped = {};
  std::function<bool()> interrupted = {};
  std::function<void(const Simulation&)> picture = {};  ///< at the scene's time
};

/// Runs a scene to its time and measures on the way. Returns less where it is interrupted. Throws as Simulation::step.
std::vector<GalleryRow> run_gallery_scene(const GalleryScene& scene, const GalleryHooks& hooks = {});

/// Writes all rows at once. Throws base::FileError.
void write_gallery(const std::filesystem::path& file, const std::vector<GalleryRow>& rows);

}  // namespace foamsim
