#include "FoamSim/studies/reproduce/report_scene.h"

#include <algorithm>
#include <vector>

#include "FoamSim/scenes/methods.h"

namespace foamsim {

namespace {

// Beyond it a free swing of the vortex sheet does not stay smooth: at N = 96 the film near a pole breaks up at time
// 0.85.
constexpr long largest_free = 48;

}  // namespace

std::optional<double> published_deviation(long n) {
  constexpr std::array degrees{12.79, 9.35, 4.15, 2.65};
  const auto it = std::ranges::find(report_subdivisions, n);
  if (it == report_subdivisions.end()) return {};
  return degrees.at(static_cast<std::size_t>(it - report_subdivisions.begin()));
}

Scene report_scene(long n, const std::string& area) {
  Scene scene = built_in_scene("doublebubble");
  base::OptionSet& options = scene.options;
  constexpr const char* where = "the report's scene";
  options.set("n", n, where);
  choose_method(options, area, where);
  if (area == "constant-edge") options.set("phi", 0.75, where);
  if (area == conservative_method) {
    // Not of the report: with its own defaults.
    options.set_text("dt", "auto", where);
  } else {
    options.set("dt", n <= largest_free ? 0.01 : 0.005, where);
    options.set("diffusion", n <= largest_free ? 10.0 : 20.0, where);
    options.set("remeshing.smoothing", false, where);
  }
  validate(scene);
  return scene;
}

Scene report_scene_to_rest(long n, const std::string& area) {
  Scene scene = report_scene(n, area);
  constexpr const char* where = "the report's scene";
  scene.options.append("effects", "damping", where);
  scene.options.set("damping", 0.02, where);
  const bool free = n <= largest_free || area == conservative_method;
  scene.options.set("damping_from", free ? 4.0 : 0.0, where);
  return scene;
}

}  // namespace foamsim
