#include "FoamSim/studies/reproduce/figure1.h"

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "FoamSim/studies/reproduce/report_scene.h"

namespace foamsim {

std::vector<ComparedRun> run_figure1(const Figure1Options& options, const RunSettings& settings,
                                     const std::function<RunHooks(const std::string& area)>& hooks_for) {
  // The strategy with an option of its own, which the others leave alone.
  Scene scene = report_scene(options.n, "constant-edge");
  const long steps = std::lround(options.time / scene.options.number("dt"));
  scene.options.set("frame_every", std::max(1L, steps / options.frames), "figure 1");
  scene.options.set("metrics_every", 5L, "figure 1");
  RunSettings own = settings;
  own.stop = {options.time, {}, false};
  return compare_areas(scene, {compared_methods.begin(), compared_methods.end()}, own, hooks_for);
}

double drift_ratio(const std::vector<ComparisonRow>& rows, const std::string& area) {
  const auto drift_of = [&](const std::string& name) {
    const auto row = std::ranges::find(rows, name, &ComparisonRow::area);
    if (row == rows.end()) throw base::InputError("figure 1: the comparison has no row of '" + name + "'");
    return row->centroid_drift;
  };
  return drift_of("naive") / drift_of(area);
}

}  // namespace foamsim
