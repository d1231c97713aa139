// The report's double bubble over a thousand steps with remeshing: volumes, resolution and soundness are kept.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "tests/support/film_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::SurfaceMesh;

Simulation remeshed_double_bubble(long n) {
  Scene scene = built_in_scene("doublebubble");
  scene.options.set("n", n, "test");
  scene.options.set("area", std::string("averaged"), "test");
  scene.options.set("remeshing.enabled", true, "test");
  return make_simulation(scene);
}

double worst_volume_change(const std::vector<lostopos::RegionVolume>& start, const SurfaceMesh& mesh) {
  const auto now = lostopos::region_volumes(mesh);
  EXPECT_EQ(now.size(), start.size());
  double worst = 0;
  for (std::size_t i = 0; i < std::min(start.size(), now.size()); ++i)
    if (start[i].region != air) worst = std::max(worst, std::abs(now[i].volume / start[i].volume - 1));
  return worst;
}

double share_of_edges_out_of_bounds(const SurfaceMesh& mesh, double h) {
  std::size_t out = 0;
  for (lostopos::Edge e : mesh.edges()) {
    const double l = length(mesh, e);
    out += l < 0.5 * h || l > 1.5 * h ? 1U : 0U;
  }
  return static_cast<double>(out) / static_cast<double>(mesh.edge_count());
}

// A count over the second half of a run, a step and triangle (or edge).
struct Rate {
  double sum = 0, most = 0;
  int steps = 0;
  void add(std::size_t count, std::size_t elements) {
    const double rate = static_cast<double>(count) / static_cast<double>(elements);
    sum += rate;
    most = std::max(most, rate);
    ++steps;
  }
  double mean() const { return sum / steps; }
};

struct Course {
  double volume_change = 0;       ///< the largest of any region at any step
  double edges_out = 0;           ///< largest share of edges out of [0.5, 1.5] h̄ at any step
  double edges_out_sum = 0;       ///< over the steps
  double smallest_fraction = 1;   ///< of the predicted motion
  Rate operations, refusals;      ///< after half the steps, over triangles and over edges
  double most_refusals_ever = 0;  ///< in a step, over edges
};

std::size_t refusals(const lostopos::RemeshStatistics& remesh) {
  std::size_t sum = 0;
  for (const auto& operation : remesh.operations) sum += operation.refused_in_all();
  return sum;
}

void follow(Simulation& simulation, int steps, int audit_every, Course& course) {
  const auto volumes = lostopos::region_volumes(simulation.mesh());
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.step();
    const SurfaceMesh& mesh = simulation.mesh();
    course.volume_change = std::max(course.volume_change, worst_volume_change(volumes, mesh));
    const double out = share_of_edges_out_of_bounds(mesh, simulation.resolution());
    course.edges_out = std::max(course.edges_out, out);
    course.edges_out_sum += out;
    course.smallest_fraction = std::min(course.smallest_fraction, report.motion_fraction);
    Rate refused;
    refused.add(refusals(report.remesh), mesh.edge_count());
    course.most_refusals_ever = std::max(course.most_refusals_ever, refused.most);
    if (i >= steps / 2) {
      course.operations.add(report.remesh.done_in_all(), mesh.triangle_count());
      course.refusals.add(refusals(report.remesh), mesh.edge_count());
    }
    if ((i + 1) % audit_every == 0) {
      ASSERT_EQ(lostopos::audit(mesh).text(), "clean") << "step " << i + 1;
    }
  }
}

// No refusal storm: a pass never asks for more than an operation an edge in vain, and the second half of the run, when
// the start shape's poles and creases are gone, asks in vain for few and does few.
void keeps_volumes_and_resolution(long n, int audit_every) {
  constexpr int steps = 1000;
  Simulation simulation = remeshed_double_bubble(n);
  Course course;
  ASSERT_NO_FATAL_FAILURE(follow(simulation, steps, audit_every, course));
  std::printf(
      "n=%ld: %zu triangles, volumes within %.4f %%, edges out of bounds %.3f %% at most, %.3f %% on average; in the "
      "second half operations %.3f %% of the triangles a step (at most %.3f %%), refusals %.3f %% of the edges (at "
      "most "
      "%.3f %%; ever %.3f %%); smallest fraction of a motion %g\n",
      n, simulation.mesh().triangle_count(), 100 * course.volume_change, 100 * course.edges_out,
      100 * course.edges_out_sum / steps, 100 * course.operations.mean(), 100 * course.operations.most,
      100 * course.refusals.mean(), 100 * course.refusals.most, 100 * course.most_refusals_ever,
      course.smallest_fraction);
  EXPECT_LT(course.volume_change, 0.01);
  EXPECT_LT(course.edges_out, 0.01);
  EXPECT_EQ(course.smallest_fraction, 1);
  EXPECT_LT(course.most_refusals_ever, 1);
  EXPECT_LT(course.refusals.mean(), 0.01);
  EXPECT_LT(course.operations.mean(), 0.01);
  EXPECT_EQ(lostopos::euler_characteristic(simulation.mesh()), 3);
  for (lostopos::Vertex v : simulation.mesh().vertices())
    for (const PairCirculation& held : simulation.circulation().at(v)) ASSERT_TRUE(std::isfinite(held.value));
}

TEST(RemeshedDoubleBubble, KeepsVolumesAndResolutionOverAThousandSteps16) {
  keeps_volumes_and_resolution(16, 1);
}

TEST(RemeshedDoubleBubble, KeepsVolumesAndResolutionOverAThousandSteps24) {
  keeps_volumes_and_resolution(24, 25);
}

struct End {
  SurfaceMesh::State mesh;
  std::vector<double> circulation;
  std::size_t operations = 0;
};

End end_of_a_run(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Simulation simulation = remeshed_double_bubble(16);
  End end;
  for (int i = 0; i < 50; ++i) end.operations += simulation.step().remesh.done_in_all();
  end.mesh = simulation.mesh().state();
  for (lostopos::Vertex v : simulation.mesh().vertices())
    for (const PairCirculation& held : simulation.circulation().at(v)) end.circulation.push_back(held.value);
  return end;
}

TEST(RemeshedDoubleBubble, HasTheSameBitsWithOneAndTwoThreads) {
  const End one = end_of_a_run(1), two = end_of_a_run(2);
  EXPECT_GT(one.operations, 100U) << "nothing was remeshed: the test would show nothing";
  EXPECT_TRUE(lostopos::test::same_bits(one.mesh, two.mesh));
  EXPECT_EQ(one.circulation, two.circulation);
}

}  // namespace
}  // namespace foamsim
