#include "FoamSim/studies/reproduce/table1.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "Base/io/write_error.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/studies/reproduce/border_height.h"
#include "FoamSim/studies/reproduce/table1_csv.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim {
namespace {

struct Case {
  std::string area;
  long n;
};

// Triangles grow with n², summation of velocities with n⁴ and takes half of a step at n = 48.
double work(long n) {
  const double x = static_cast<double>(n) / 48;
  return x * x * (1 + x * x);
}

double exact_facets(const std::vector<lostopos::RegionVolume>& volumes, double mean_edge) {
  // The air, bubble 1, bubble 2.
  const DoubleBubbleEquilibrium e = double_bubble_equilibrium(volumes.at(1).volume, volumes.at(2).volume);
  const long segments = std::max(6L, std::lround(2 * std::numbers::pi * e.rim_radius / mean_edge));
  return junction_angles(exact_double_bubble(e, segments)).rms_deviation_deg.value();
}

Table1Row row_of(const Case& which, const RunOutcome& outcome, double cpu_seconds) {
  const lostopos::SurfaceMesh mesh = lostopos::to_mesh(lostopos::read_surface(outcome.last_frame));
  const Metrics& m = outcome.last;
  Table1Row row;
  row.area = which.area;
  row.n = which.n;
  row.triangles_start = static_cast<long>(outcome.start.triangles);
  row.triangles = static_cast<long>(m.triangles);
  row.angle_rms_deg = m.angle_rms_deg;
  row.angle_rms_film_deg = m.angle_rms_film_deg;
  if (which.area == "averaged") row.published_deg = published_deviation(which.n);
  row.angle_outer_mean_deg = m.angle_outer_mean_deg;
  row.angle_outer_mean_film_deg = m.angle_outer_mean_film_deg;
  row.exact_facets_deg = exact_facets(outcome.start.volumes, lostopos::mean_edge_length(mesh));
  row.border_height = mean_border_height(mesh);
  row.volume_drift_max = m.volume_drift_max;
  row.centroid_drift = (m.centroid - outcome.start_centroid).norm();
  row.steps = m.step;
  row.time = m.time;
  row.cpu_seconds = cpu_seconds;
  row.wall_seconds = outcome.wall_seconds;
  row.ended = std::string(name(outcome.end));
  return row;
}

// Beyond it the conservative row, which is ours, would take hours with direct sums.
constexpr long largest_conservative = 48;

class Table1 {
 public:
  Table1(const Table1Settings& settings, const Table1Hooks& hooks)
      : settings_(settings), hooks_(hooks), file_(settings.out / "table1.csv") {
    if (!settings.force && std::filesystem::exists(file_)) rows_ = read_table1(file_);
    for (long n : settings.subdivisions)
      for (const std::string& area : settings.areas)
        if (area != conservative_method || n <= largest_conservative) cases_.push_back({area, n});
    for (const Case& c : cases_)
      if (find(c) == rows_.end()) work_left_ += work(c.n);
  }

  std::vector<Table1Row> make() {
    // All scenes first: an error in one is found before anything is written.
    for (const Case& c : cases_) report_scene_to_rest(c.n, c.area);
    base::make_folder(settings_.out);
    std::vector<Table1Row> asked;
    for (const Case& c : cases_) {
      if (find(c) == rows_.end() && !run(c)) break;
      asked.push_back(*find(c));
    }
    return asked;
  }

 private:
  std::vector<Table1Row>::iterator find(const Case& c) {
    return std::ranges::find_if(rows_, [&](const Table1Row& row) { return row.area == c.area && row.n == c.n; });
  }

  // False when interrupted.
  bool run(const Case& c) {
    RunSettings run;
    run.out = settings_.out / "table1" / (c.area + "-" + std::to_string(c.n));
    run.force = true;  // What an interrupted run has left there is of no use.
    run.stop = {settings_.longest_time, {}, true};
    run.command = settings_.command;
    Scene scene = report_scene_to_rest(c.n, c.area);
    scene.options.set("frame_every", 0L, "table 1");
    const double begin = work_done_ / work_left_;
    work_done_ += work(c.n);
    const RunHooks own = hooks_.run ? hooks_.run(c.area, c.n, begin, work_done_ / work_left_) : RunHooks();
    const std::clock_t start = std::clock();
    const RunOutcome outcome = run_scene(scene, run, own);
    if (outcome.end == RunEnd::interrupted) return false;
    rows_.push_back(row_of(c, outcome, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC));
    write_table1(file_, rows_);
    if (hooks_.row) hooks_.row(rows_.back());
    return true;
  }

  const Table1Settings& settings_;
  const Table1Hooks& hooks_;
  std::filesystem::path file_;
  std::vector<Case> cases_;
  std::vector<Table1Row> rows_;
  double work_left_ = 0, work_done_ = 0;
};

}  // namespace

std::optional<double> Table1Row::difference_deg() const {
  if (!angle_rms_deg || !published_deg) return {};
  return *angle_rms_deg - *published_deg;
}

std::vector<Table1Row> make_table1(const Table1Settings& settings, const Table1Hooks& hooks) {
  return Table1(settings, hooks).make();
}

std::optional<double> observed_order(const Table1Row& coarse, const Table1Row& fine) {
  if (!coarse.angle_rms_deg || !fine.angle_rms_deg) return {};
  return std::log(*coarse.angle_rms_deg / *fine.angle_rms_deg) /
         std::log(static_cast<double>(fine.n) / static_cast<double>(coarse.n));
}

}  // namespace foamsim
