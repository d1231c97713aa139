#include "FoamSim/run/compare.h"

#include "FoamSim/options/option_value.h"
#include "LosTopos/error.h"
#include "LosTopos/io/atomic_file.h"

namespace foamsim {
namespace {

std::string text(const std::optional<double>& value) {
  return value ? to_text(*value) : "";
}

void write_table(const std::filesystem::path& file, const std::vector<ComparedRun>& runs) {
  lostopos::AtomicFile out(file);
  out.stream()
      << "area,ended,steps,time,triangles,angle_outer_mean_deg,angle_rms_deg,centroid_drift,surface_area,energy,"
         "volume_drift_max,seconds\n";
  for (const ComparedRun& run : runs) {
    const Metrics& m = run.outcome.last;
    out.stream() << run.area << ',' << name(run.outcome.end) << ',' << m.step << ',' << to_text(m.time) << ','
                 << m.triangles << ',' << text(m.angle_outer_mean_deg) << ',' << text(m.angle_rms_deg) << ','
                 << to_text(run.centroid_drift()) << ',' << to_text(m.area) << ',' << to_text(m.energy) << ','
                 << to_text(m.volume_drift_max) << ',' << to_text(run.outcome.wall_seconds) << '\n';
  }
  out.commit();
}

}  // namespace

double ComparedRun::centroid_drift() const {
  return (outcome.last.centroid - outcome.start_centroid).norm();
}

std::vector<ComparedRun> compare_areas(const Scene& scene, const std::vector<std::string>& areas,
                                       const RunSettings& settings,
                                       const std::function<RunHooks(const std::string& area)>& hooks_for) {
  // All scenes first: a misspelt strategy is an error before anything is written.
  std::vector<Scene> scenes;
  for (const std::string& area : areas) {
    scenes.push_back(scene);
    scenes.back().options.set("area", area, "--areas");
    validate(scenes.back());
  }
  if (!settings.force && std::filesystem::exists(settings.out / "compare.csv"))
    throw lostopos::InputError(settings.out.string() +
                               " already holds a comparison; give another --out, or --force to replace it");
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    RunSettings own = settings;
    own.out = settings.out / areas[i];
    runs.push_back({areas[i], run_scene(scenes[i], own, hooks_for(areas[i]))});
    if (runs.back().outcome.end == RunEnd::interrupted) break;
  }
  write_table(settings.out / "compare.csv", runs);
  return runs;
}

}  // namespace foamsim
