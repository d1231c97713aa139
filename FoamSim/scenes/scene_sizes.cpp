#include "FoamSim/scenes/scene_sizes.h"

#include <cmath>

namespace foamsim {

using base::OptionSpec;
using base::OptionValue;

OptionSpec subdivisions(long default_value, std::string summary, long least) {
  // Beyond eight subdivisions (over a million triangles) direct summation would not end in a lifetime of patience.
  return whole_between(least, 8, default_value, "n", std::move(summary));
}

std::function<double(const base::OptionSet&)> triangles_of_subdivided(double coarsest) {
  return [coarsest](const base::OptionSet& options) {
    return coarsest * std::pow(4.0, static_cast<double>(options.whole("n")));
  };
}

std::function<double(const base::OptionSet&)> triangles_of_rings(double surfaces) {
  return [surfaces](const base::OptionSet& options) {
    const long n = options.whole("n"), m = options.has("m") ? options.whole("m") : 0;
    return 2 * surfaces * static_cast<double>(n) * static_cast<double>(m > 0 ? m : n);
  };
}

SceneEntry sized(SceneEntry scene, std::function<double(const base::OptionSet&)> triangles) {
  scene.triangles = std::move(triangles);
  return scene;
}

OptionSpec number_below(double bound, const std::string& bound_text, std::string key, double default_value,
                        std::string summary) {
  return {std::move(key), default_value, std::move(summary), "a number between -" + bound_text + " and " + bound_text,
          [bound](const OptionValue& value) { return std::abs(std::get<double>(value)) < bound; }};
}

}  // namespace foamsim
