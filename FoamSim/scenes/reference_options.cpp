#include "FoamSim/scenes/reference_options.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "Base/error.h"
#include "Base/names/nearest_name.h"

namespace foamsim {

namespace {

struct Line {
  std::string key, value, where;
};

// Its key, and ours; an empty one of ours: read, without meaning here.
struct KeyMeaning {
  std::string_view name, ours;
};
constexpr std::array meanings{
    KeyMeaning{"scene", "scene"},
    KeyMeaning{"time-step", "dt"},
    KeyMeaning{"simulation-time", "time"},
    KeyMeaning{"smoothing-coef", "diffusion"},
    KeyMeaning{"damping-coef", "damping"},
    KeyMeaning{"sigma", "sigma"},
    KeyMeaning{"RK4-velocity-integration", "integrator"},
    KeyMeaning{"remeshing-resolution", "resolution"},
    KeyMeaning{"mesh-size-n", "n"},
    KeyMeaning{"output-mesh-every-n-frames", "frame_every"},
    KeyMeaning{"load-dir", ""},
    KeyMeaning{"implicit-integration", ""},
    KeyMeaning{"pbd-implicit", ""},
    KeyMeaning{"gravity", ""},
    KeyMeaning{"fmmtl", ""},
    KeyMeaning{"looped", ""},
    KeyMeaning{"radius", ""},
    KeyMeaning{"density", ""},
    KeyMeaning{"stretching", ""},
    KeyMeaning{"bending", ""},
    KeyMeaning{"output-mesh", ""},
    KeyMeaning{"output-obj", ""},
    KeyMeaning{"output-obj-every-n-frames", ""},
    KeyMeaning{"remeshing-iterations", ""},
    KeyMeaning{"lostopos-collision-epsilon-fraction", ""},
    KeyMeaning{"lostopos-merge-proximity-epsilon-fraction", "topology.merge_distance"},
    KeyMeaning{"lostopos-perform-smoothing", ""},
    KeyMeaning{"lostopos-max-volume-change-fraction", ""},
    KeyMeaning{"lostopos-min-triangle-angle", ""},
    KeyMeaning{"lostopos-max-triangle-angle", ""},
    KeyMeaning{"lostopos-large-triangle-angle-to-split", ""},
    KeyMeaning{"lostopos-min-triangle-area-fraction", ""},
    KeyMeaning{"lostopos-t1-transition-enabled", "topology.separate"},
    KeyMeaning{"lostopos-t1-pull-apart-distance-fraction", "topology.pull_apart"},
    KeyMeaning{"lostopos-smooth-subdivision", ""},
    KeyMeaning{"lostopos-allow-non-manifold", ""},
    KeyMeaning{"lostopos-allow-topology-changes", "topology.enabled"},
    KeyMeaning{"mesh-size-m", ""},
    KeyMeaning{"foam-burst-interval", ""},
    KeyMeaning{"foam-burst-start", ""},
};

std::vector<Line> read_lines(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw base::FileError(file + ": there is no such option file, or it cannot be read");
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number) {
    std::istringstream words(text.substr(0, text.find('#')));
    Line line;
    if (!(words >> line.key)) continue;
    line.where = file + ":" + std::to_string(number);
    std::string more;
    if (!(words >> line.value) || words >> more)
      throw base::InputError(line.where + ": one value has to follow the key '" + line.key + "'");
    lines.push_back(std::move(line));
  }
  return lines;
}

void apply(const Line& line, std::string_view ours, Scene& scene) {
  base::OptionSet& options = scene.options;
  if (ours == "integrator") {
    const base::OptionValue on = base::parse_option(line.value, false);
    options.set("integrator", std::string(std::get<bool>(on) ? "rk4" : "euler"), line.where);
    return;
  }
  options.set_text(ours, line.value, line.where);
  if (ours == "time") options.set("time", options.number("time") / 2, line.where);
  if (ours == "damping") options.append("effects", "damping", line.where);
}

}  // namespace

Scene read_reference_options(const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  const std::vector<Line> lines = read_lines(file);
  const auto scene_line = std::ranges::find(lines, "scene", &Line::key);
  if (scene_line == lines.end()) throw base::InputError(file + ": an option file needs a line 'scene NAME'");
  Scene scene = [&] {
    try {
      return built_in_scene(scene_line->value, std::move(catalogue));
    } catch (const base::InputError& error) {
      throw base::InputError(scene_line->where + ": " + error.what());
    }
  }();
  for (const Line& line : lines) {
    std::string_view ours;
    try {
      ours = base::find_by_name(meanings, line.key, "key").ours;
    } catch (const base::InputError& error) {
      throw base::InputError(line.where + ": " + error.what());
    }
    if (ours == "scene") continue;
    if (ours.empty() || !scene.options.has(ours))
      scene.notes.push_back(line.where + ": '" + line.key + "' has no meaning here and is left out");
    else
      apply(line, ours, scene);
  }
  return scene;
}

}  // namespace foamsim
