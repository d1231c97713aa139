#include "FoamSim/studies/stability/stability_study.h"

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/studies/require.h"

namespace foamsim {
namespace {

struct Combination {
  const StabilityCase* what;
  CaseSetup setup;
  double weight;  // roughly what it costs: steps times triangles
};

std::vector<std::string> areas_for(const StabilityCase& what, const StabilityOptions& o) {
  switch (what.strategies) {
    case Strategies::all:
      return o.areas;
    case Strategies::averaging: {
      std::vector<std::string> areas = o.areas;
      std::erase_if(areas, [](const std::string& area) { return area == "naive" || area == "constant-edge"; });
      return areas;
    }
    case Strategies::none:
      return {"averaged"};
  }
  return {};
}

double weight_of(const StabilityCase& what, const CaseSetup& setup) {
  long steps = 0;
  for (const CaseRun& run : what.runs(setup)) steps += run.steps;
  return static_cast<double>(steps) * static_cast<double>(what.typical_triangles);
}

std::vector<Combination> set_up(const StabilityOptions& o) {
  std::vector<Combination> all;
  for (const StabilityCase& what : stability_cases()) {
    const bool named = std::ranges::find(o.cases, what.name) != o.cases.end();
    if (!named && (!o.cases.empty() || what.when_named)) continue;
    for (const std::string& area : areas_for(what, o))
      for (bool remeshing : o.remeshing) {
        if (!remeshing && what.remeshing == Remeshing::on_only) continue;
        const CaseSetup setup{area, remeshing, o.steps_scale, o.assignments};
        all.push_back({&what, setup, weight_of(what, setup)});
      }
  }
  return all;
}

StabilityRow row_of(const StabilityCase& what, const CaseSetup& setup, const std::vector<Trajectory>& trajectories) {
  StabilityRow row;
  row.name = what.name;
  row.area = what.strategies == Strategies::none ? "-" : setup.area;
  row.remeshing = setup.remeshing;
  row.verdict = what.judge(trajectories);
  for (const Trajectory& t : trajectories) {
    const PhysicsFigures figures = physics_figures(t);
    row.physics.energy_rise = std::max(row.physics.energy_rise, figures.energy_rise);
    row.physics.volume_drift = std::max(row.physics.volume_drift, figures.volume_drift);
    row.physics.impulse_drift = std::max(row.physics.impulse_drift, figures.impulse_drift);
    row.physics.finite = row.physics.finite && figures.finite;
    row.steps += t.steps();
    row.steps_asked += t.steps_asked;
    row.seconds += t.seconds;
    if (t.samples.empty()) continue;
    row.time = t.samples.back().time;
    row.triangles = t.samples.back().triangles;
  }
  return row;
}

}  // namespace

std::vector<StabilityCombination> combinations(const StabilityOptions& o) {
  std::vector<StabilityCombination> all;
  for (const Combination& c : set_up(o)) all.push_back({std::string(c.what->name), c.setup.area, c.setup.remeshing});
  return all;
}

void validate(const StabilityOptions& o) {
  for (const std::string& name : o.cases) stability_case_by_name(name);
  for (const std::string& area : o.areas) require_method(*built_in_catalogue(), area);
  require(!o.areas.empty(), "stability study: one strategy or more has to be given");
  require(!o.remeshing.empty(), "stability study: remeshing has to be on, off, or both");
  require(o.steps_scale > 0 && o.steps_scale <= 10, "stability study: the steps' scale has to be > 0 and at most 10");
  require(std::isfinite(o.most_seconds) && o.most_seconds > 0,
          "stability study: the bound on wall time has to be a finite time > 0");
  for (const std::string& area : o.areas) {
    Scene scene = built_in_scene("doublebubble");
    choose_method(scene.options, area, "stability study");
    for (const std::string& assignment : o.assignments) scene.options.set_assignment(assignment, "--set");
    validate(scene);
  }
}

std::optional<StabilityRow> run_stability_case(const StabilityCase& what, const CaseSetup& setup, double most_seconds,
                                               const RecordHooks& hooks) {
  std::vector<Trajectory> trajectories;
  long before = 0;
  for (const CaseRun& run : what.runs(setup)) {
    RecordHooks shifted{.progress = {}, .interrupted = hooks.interrupted};
    if (hooks.progress) shifted.progress = [&](long steps) { hooks.progress(before + steps); };
    trajectories.push_back(record(run.start, {.steps = run.steps, .most_seconds = most_seconds}, shifted));
    trajectories.back().label = run.label;
    trajectories.back().limits = physics_limits(setup.area);
    if (trajectories.back().interrupted) return std::nullopt;
    before += run.steps;
  }
  return row_of(what, setup, trajectories);
}

std::vector<StabilityRow> study_stability(const StabilityOptions& options, const StabilityHooks& hooks) {
  validate(options);
  const auto all = set_up(options);
  double weight = 0, done = 0;
  for (const Combination& c : all) weight += c.weight;
  std::vector<StabilityRow> rows;
  for (const Combination& c : all) {
    const std::string label = std::string(c.what->name) + " " + c.setup.area + (c.setup.remeshing ? "" : " fixed mesh");
    RecordHooks record_hooks{.progress = {}, .interrupted = hooks.interrupted};
    if (hooks.progress)
      record_hooks.progress = [&](long steps) {
        hooks.progress(label, (done + static_cast<double>(steps * c.what->typical_triangles)) / weight);
      };
    auto row = run_stability_case(*c.what, c.setup, options.most_seconds, record_hooks);
    if (!row) break;
    if (hooks.row) hooks.row(*row);
    rows.push_back(std::move(*row));
    done += c.weight;
  }
  return rows;
}

}  // namespace foamsim
