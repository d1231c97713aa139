#include "FoamSim/run/compare.h"

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/csv_table.h"
#include "Base/options/option_value.h"
#include "FoamSim/scenes/methods.h"

namespace foamsim {
namespace {

constexpr const char* header =
    "area,ended,steps,time,triangles,angle_outer_mean_deg,angle_rms_deg,centroid_drift,surface_area,energy,"
    "volume_drift_max,seconds,angle_rms_film_deg";

std::string text(const std::optional<double>& value) {
  return value ? base::to_text(*value) : "";
}

void write_table(const std::filesystem::path& file, const std::vector<ComparedRun>& runs) {
  base::AtomicFile out(file);
  out.stream() << header << '\n';
  for (const ComparedRun& run : runs) {
    const ComparisonRow r = summarise(run);
    out.stream() << r.area << ',' << r.ended << ',' << r.steps << ',' << base::to_text(r.time) << ',' << r.triangles
                 << ',' << text(r.angle_outer_mean_deg) << ',' << text(r.angle_rms_deg) << ','
                 << base::to_text(r.centroid_drift) << ',' << base::to_text(r.surface_area) << ','
                 << base::to_text(r.energy) << ',' << base::to_text(r.volume_drift_max) << ','
                 << base::to_text(r.seconds) << ',' << text(r.angle_rms_film_deg) << '\n';
  }
  out.commit();
}

ComparisonRow parse_row(const std::vector<std::string>& cells) {
  auto number = [](const std::string& cell) { return std::get<double>(base::parse_option(cell, 0.0)); };
  auto whole = [](const std::string& cell) { return std::get<long>(base::parse_option(cell, 0L)); };
  auto optional = [&](const std::string& cell) { return cell.empty() ? std::optional<double>() : number(cell); };
  return {cells[0],           cells[1],           whole(cells[2]),    number(cells[3]), whole(cells[4]),
          optional(cells[5]), optional(cells[6]), number(cells[7]),   number(cells[8]), number(cells[9]),
          number(cells[10]),  number(cells[11]),  optional(cells[12])};
}

}  // namespace

ComparisonRow summarise(const ComparedRun& run) {
  const Metrics& m = run.outcome.last;
  return {run.area,
          std::string(name(run.outcome.end)),
          m.step,
          m.time,
          static_cast<long>(m.triangles),
          m.angle_outer_mean_deg,
          m.angle_rms_deg,
          (m.centroid - run.outcome.start_centroid).norm(),
          m.area,
          m.energy,
          m.volume_drift_max,
          run.outcome.wall_seconds,
          m.angle_rms_film_deg};
}

std::vector<ComparisonRow> read_comparison(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw base::FileError(file.string() + ": there is no comparison; 'foamsim compare' makes one");
  std::vector<ComparisonRow> rows;
  base::read_csv(file, header, [&](const std::vector<std::string>& cells) { rows.push_back(parse_row(cells)); });
  return rows;
}

std::vector<ComparedRun> compare_areas(const Scene& scene, const std::vector<std::string>& areas,
                                       const RunSettings& settings,
                                       const std::function<RunHooks(const std::string& area)>& hooks_for) {
  // All scenes first: a misspelt strategy is an error before anything is written.
  std::vector<Scene> scenes;
  for (const std::string& area : areas) require_method(*scene.catalogue, area);
  validate(scene, also_used_by(areas));
  for (const std::string& area : areas) {
    scenes.push_back(scene);
    choose_method(scenes.back().options, area, "--areas");
    validate(scenes.back(), also_used_by(areas));
  }
  if (!settings.force && std::filesystem::exists(settings.out / "compare.csv"))
    throw base::InputError(settings.out.string() +
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
