// What the tracker takes of a step, by stage, on one core: a double bubble at rest that drifts by 0.05 resolutions a
// step, at growing size and with large labels; then whole steps of the simulated double bubble.
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "Base/timing/stopwatch.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/surface_tracker.h"

namespace {

using lostopos::Operation;
using lostopos::SurfaceMesh;
using lostopos::SurfaceTracker;
using lostopos::Vec3;

constexpr int most_passes_to_rest = 60;
constexpr int steps = 21;
constexpr std::size_t stage_count = 10;
constexpr std::array<const char*, stage_count> stage_names{"broad",    "ccd",  "impulses", "topology", "split",
                                                           "collapse", "flip", "smooth",   "other",    "total"};

struct Row {
  std::size_t triangles = 0;
  std::array<double, stage_count> seconds{};  ///< of the fastest step: other programs disturb it least
  double median = 0;                          ///< of the steps' totals, s
  std::size_t collisions = 0, operations = 0;
  int passes_to_rest = 0;
  double mesh_bytes = 0;  ///< a triangle
  double total() const { return seconds.back(); }
  double us_a_triangle() const { return 1e6 * total() / static_cast<double>(triangles); }
};

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void offset_labels(SurfaceMesh& mesh, std::size_t offset) {
  auto renamed = [offset](lostopos::Region r) { return r == lostopos::air ? r : lostopos::Region(r.index() + offset); };
  for (lostopos::Triangle t : mesh.triangles()) {
    const lostopos::Labels labels = mesh.labels(t);
    mesh.set_labels(t, {renamed(labels.p), renamed(labels.q)});
  }
}

// A smooth swirl of at most 0.05 resolutions; `sign` turns it round, so that the surface stays near its rest.
std::vector<Vec3> swirled(const SurfaceMesh& mesh, double resolution, double sign) {
  std::vector<Vec3> predicted(mesh.positions().begin(), mesh.positions().end());
  for (Vec3& x : predicted) {
    const Vec3 u(std::sin(2 * x[1]), std::sin(2 * x[2] + 1), std::sin(2 * x[0] + 2));
    x += sign * 0.05 * resolution / std::sqrt(3.0) * u;
  }
  return predicted;
}

// One step there or back; counts go to `row`.
std::array<double, stage_count> measured_step(SurfaceTracker& tracker, double sign, Row& row) {
  const std::vector<Vec3> predicted = swirled(tracker.mesh(), tracker.options().resolution, sign);
  const base::Stopwatch watch;
  const lostopos::TrackerStep done = tracker.step(predicted);
  const lostopos::MoveStatistics& move = done.move.statistics;
  const lostopos::RemeshStatistics& remesh = done.remesh;
  const double total = watch.seconds();
  std::array<double, stage_count> seconds{move.broad_phase_seconds,
                                          move.ccd_seconds,
                                          move.impulse_seconds + move.zone_seconds,
                                          done.topology_seconds,
                                          remesh[Operation::split].seconds,
                                          remesh[Operation::collapse].seconds,
                                          remesh[Operation::flip].seconds,
                                          remesh[Operation::smoothing].seconds,
                                          0,
                                          total};
  seconds[stage_count - 2] = total - std::accumulate(seconds.begin(), seconds.end() - 2, 0.0);
  row.collisions += move.collisions;
  row.operations += remesh.done_in_all() + done.topology.done_in_all();
  return seconds;
}

Row quiet_steps(long n, std::size_t label_offset) {
  SurfaceMesh mesh = foamsim::double_bubble(n);
  offset_labels(mesh, label_offset);
  lostopos::TrackerOptions options{.resolution = mean_edge_length(mesh)};
  options.topology.enabled = true;
  SurfaceTracker tracker(std::move(mesh), options);
  Row row;
  while (row.passes_to_rest < most_passes_to_rest && tracker.remesh().done_in_all() > 0) ++row.passes_to_rest;
  Row warm_up;
  for (double sign : {1.0, -1.0}) measured_step(tracker, sign, warm_up);
  std::array<std::array<double, stage_count>, steps> measured;
  for (int i = 0; i < steps; ++i)
    measured[static_cast<std::size_t>(i)] = measured_step(tracker, i % 2 == 0 ? 1 : -1, row);
  std::ranges::sort(measured, {}, [](const auto& seconds) { return seconds.back(); });
  row.seconds = measured.front();
  row.median = measured[steps / 2].back();
  row.triangles = tracker.mesh().triangle_count();
  row.mesh_bytes = static_cast<double>(tracker.mesh().memory_bytes()) / static_cast<double>(row.triangles);
  return row;
}

void print_header() {
  std::printf("%9s", "triangles");
  for (const char* name : stage_names) std::printf(" %9s", name);
  std::printf(" %9s %9s %6s %6s %7s %7s %8s\n", "median", "us/tri", "coll.", "ops", "passes", "B/tri", "peak MB");
}

void print_row(const Row& row) {
  std::printf("%9zu", row.triangles);
  for (double seconds : row.seconds) std::printf(" %9.6f", seconds);
  std::printf(" %9.6f %9.2f %6zu %6zu %7d %7.0f %8.0f\n", row.median, row.us_a_triangle(), row.collisions,
              row.operations, row.passes_to_rest, row.mesh_bytes, peak_megabytes());
  std::fflush(stdout);
}

void print_table(std::size_t label_offset) {
  std::printf("\nQuiet steps, one thread, labels + %zu: seconds of the fastest step of %d, median of the totals\n",
              label_offset, steps);
  print_header();
  Row ten, forty;
  for (long n : {24L, 48L, 97L, 154L}) {
    const Row row = quiet_steps(n, label_offset);
    print_row(row);
    if (n == 48) ten = row;
    if (n == 97) forty = row;
  }
  std::printf("from 10,000 to 40,000 triangles: %.2f times (%.2f times the triangles)\n", forty.total() / ten.total(),
              static_cast<double>(forty.triangles) / static_cast<double>(ten.triangles));
}

void print_simulation() {
  constexpr int simulated_steps = 30;
  foamsim::Scene scene = foamsim::built_in_scene("doublebubble");
  scene.options.set("n", 48L, "benchmark");
  scene.options.set("topology.enabled", true, "benchmark");
  foamsim::Simulation simulation = foamsim::make_simulation(scene);
  base::StageTimes times;
  lostopos::MoveStatistics move;
  lostopos::RemeshStatistics remesh;
  const base::Stopwatch watch;
  for (int i = 0; i < simulated_steps; ++i) {
    const foamsim::StepReport report = simulation.step();
    times.add(report.times);
    move += report.move;
    remesh += report.remesh;
  }
  const double total = watch.seconds();
  std::printf("\ndoublebubble n=48, first %d steps, one thread: %zu triangles, milliseconds a step\n", simulated_steps,
              simulation.mesh().triangle_count());
  for (const auto& [stage, seconds] : times.stages())
    std::printf("%-20s %9.3f\n", stage.c_str(), 1e3 * seconds / simulated_steps);
  std::printf("%-20s %9.3f\n", "whole step", 1e3 * total / simulated_steps);
  const double tracked = times.seconds("move") + times.seconds("remesh");
  std::printf("move and remesh: %.2f us a triangle; %zu collisions, %zu operations, %.1f a step\n",
              1e6 * tracked / simulated_steps / static_cast<double>(simulation.mesh().triangle_count()),
              move.collisions, remesh.done_in_all(), static_cast<double>(remesh.done_in_all()) / simulated_steps);
  for (std::size_t i = 0; i < lostopos::operation_count; ++i) {
    const auto o = static_cast<Operation>(i);
    std::printf("  %-10s %9.3f ms, %zu done, %zu refused\n", name(o), 1e3 * remesh[o].seconds / simulated_steps,
                remesh[o].done, remesh[o].refused_in_all());
  }
}

}  // namespace

int main() {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  print_table(0);
  print_table(5000);
  print_simulation();
  return 0;
}
