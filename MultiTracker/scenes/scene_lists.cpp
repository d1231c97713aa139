#include "MultiTracker/scenes/scene_lists.h"

#include <cmath>

namespace multitracker {

base::OptionSpec subdivisions(long count) {
  return {"subdivisions", count, "of each triangle of the start surface into four", "0 to 8",
          [](const base::OptionValue& value) { return std::get<long>(value) >= 0 && std::get<long>(value) <= 8; }};
}

double subdivided(double coarsest, const base::OptionSet& options) {
  return coarsest * std::pow(4.0, static_cast<double>(options.whole("subdivisions")));
}

SceneEntry sized(SceneEntry scene, double (*triangles)(const base::OptionSet&)) {
  scene.triangles = triangles;
  return scene;
}

}  // namespace multitracker
