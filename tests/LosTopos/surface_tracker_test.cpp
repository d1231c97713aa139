#include "LosTopos/surface_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

std::vector<Vec3> positions_of(const SurfaceMesh& mesh) {
  return {mesh.positions().begin(), mesh.positions().end()};
}

SurfaceTracker double_bubble_tracker(long segments, TrackerOptions options = {}) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, segments);
  options.resolution = mean_edge_length(mesh);
  return SurfaceTracker(std::move(mesh), options);
}

// Refused with a message that has `words`, and the mesh is as it was.
void expect_refused(SurfaceTracker& tracker, std::span<const Vec3> predicted, const std::string& words) {
  const auto before = tracker.mesh().state();
  try {
    tracker.advance(predicted);
    ADD_FAILURE() << "not refused";
  } catch (const MotionError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
  EXPECT_TRUE(test::same_bits(before, tracker.mesh().state()));
}

class Advance : public testing::TestWithParam<bool> {
 protected:
  SurfaceTracker tracker = double_bubble_tracker(10, {.collisions = GetParam()});
};

TEST_P(Advance, RefusesAMotionThatIsNotResolved) {
  const double h = tracker.options().resolution;
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  for (Vec3& x : predicted) x.x() += 0.1 * h;  // the others' motion is fine, and must not be done either
  predicted[7] = tracker.mesh().position(Vertex(7)) + Vec3(0, 0, 20.001 * h);
  expect_refused(tracker, predicted, "vertex 7");
  for (Vec3& x : predicted) x.x() -= 0.1 * h;
  expect_refused(tracker, predicted, "20 resolutions");
}

TEST_P(Advance, MovesAllAsFarAsIsAllowed) {
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  for (Vec3& x : predicted) x.z() += 19.999 * tracker.options().resolution;
  EXPECT_EQ(tracker.advance(predicted).fraction, 1);
  EXPECT_EQ(positions_of(tracker.mesh()), predicted);
}

TEST_P(Advance, RefusesPredictionsThatAreNotFinite) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()})
    for (int axis : {0, 1, 2}) {
      std::vector<Vec3> predicted = positions_of(tracker.mesh());
      for (Vec3& x : predicted) x.x() += 0.01;
      predicted[3][axis] = bad;
      expect_refused(tracker, predicted, "vertex 3");
    }
}

TEST_P(Advance, RefusesTheWrongNumberOfPredictions) {
  const auto before = tracker.mesh().state();
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  predicted.pop_back();
  EXPECT_THROW(tracker.advance(predicted), base::Error);
  EXPECT_THROW(tracker.advance({}), base::Error);
  EXPECT_TRUE(test::same_bits(before, tracker.mesh().state()));
}

TEST_P(Advance, DoesNotReadThePredictionOfADeadSlot) {
  const Vertex dead = tracker.mesh().add_vertex(Vec3(5, 5, 5));
  tracker.mesh().add_vertex(Vec3(6, 6, 6));
  tracker.mesh().remove_vertex(dead);
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  for (Vec3& x : predicted) x.y() += 0.01;
  predicted[dead.index()].setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(tracker.advance(predicted).fraction, 1);
  EXPECT_EQ(tracker.mesh().position(Vertex(0)), predicted[0]);
}

INSTANTIATE_TEST_SUITE_P(Collisions, Advance, testing::Bool(),
                         [](const auto& info) { return info.param ? "avoided" : "let_be"; });

TEST(SurfaceTracker, SaysWhatIsWrongWithItsOptions) {
  EXPECT_THROW(SurfaceTracker(test::analytic_double_bubble(1, 8)), base::InputError) << "no resolution";
  TrackerOptions options{.resolution = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(SurfaceTracker(test::analytic_double_bubble(1, 8), options), base::InputError);
  options = {.resolution = 0.5, .remesh = {.shortest_edge = 0.9}};
  EXPECT_THROW(SurfaceTracker(test::analytic_double_bubble(1, 8), options), base::InputError);
  options = {.collisions = false, .remeshing = false};
  EXPECT_NO_THROW(SurfaceTracker(test::analytic_double_bubble(1, 8), options)) << "needs no resolution";
}

TEST(SurfaceTracker, RefusesLengthsThatItCannotComputeWith) {
  const auto refusal = [](double scale, double resolution) -> std::string {
    SurfaceMesh mesh = test::analytic_double_bubble(1, 8);
    for (Vertex v : mesh.vertices()) mesh.set_position(v, scale * mesh.position(v));
    try {
      SurfaceTracker(std::move(mesh), {.resolution = resolution});
    } catch (const base::InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(refusal(1e38, 0.3e38), "");
  EXPECT_EQ(refusal(1e-38, 0.3e-38), "");
  EXPECT_NE(refusal(1e41, 1e39).find("vertex"), std::string::npos);
  EXPECT_NE(refusal(1e-41, 1e-39).find("edge"), std::string::npos);
  EXPECT_NE(refusal(1, 1e-41).find("resolution"), std::string::npos);
  EXPECT_NE(refusal(1, 1e100).find("resolution"), std::string::npos);
}

// At each of its first looks in turn: the surface is whole then, and put back to the bit.
TEST(SurfaceTracker, IsInterruptedWithinAStep) {
  std::size_t looks = 0, stop_at = 0;
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  TrackerOptions options{.resolution = 0.6 * mean_edge_length(mesh)};
  options.topology.enabled = true;
  options.interruption = {[&] { return ++looks == stop_at; }};
  SurfaceTracker tracker(std::move(mesh), options);
  const auto before = tracker.state();
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  for (Vec3& x : predicted) x.x() *= 1.01;
  tracker.step(predicted);
  const std::size_t of_a_step = looks;
  EXPECT_GT(of_a_step, 100U) << "it looks often";
  for (stop_at = 1; stop_at < of_a_step; stop_at = 3 * stop_at + 1) {
    tracker.restore(before);
    looks = 0;
    EXPECT_THROW(tracker.step(predicted), base::Interrupted) << stop_at;
    EXPECT_EQ(audit(tracker.mesh()).text(), "clean") << stop_at;
    tracker.restore(before);
    EXPECT_TRUE(test::same_bits(before, tracker.state()));
  }
}

TEST(SurfaceTracker, RemeshingIsBoundedByTheMostTriangles) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  const std::size_t start = mesh.triangle_count();
  TrackerOptions options{.resolution = 0.2 * mean_edge_length(mesh)};
  options.remesh.most_triangles = 2 * start;
  SurfaceTracker tracker(std::move(mesh), options);
  try {
    tracker.remesh();
    ADD_FAILURE() << "it made " << tracker.mesh().triangle_count() << " triangles of " << start;
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("has come to " + std::to_string(2 * start)), std::string::npos)
        << error.what();
  }
  EXPECT_LE(tracker.mesh().triangle_count(), 2 * start + 4);
  EXPECT_EQ(audit(tracker.mesh()).text(), "clean");
}

TEST(SurfaceTracker, RemeshesOnlyWhenAskedTo) {
  SurfaceTracker tracker = double_bubble_tracker(12, {.remeshing = false});
  for (Vertex v : tracker.mesh().vertices()) tracker.mesh().set_position(v, 3 * tracker.mesh().position(v));
  const auto before = tracker.mesh().state();
  EXPECT_EQ(tracker.remesh().done_in_all(), 0U);
  EXPECT_TRUE(test::same_bits(before, tracker.mesh().state()));
}

TEST(SurfaceTracker, HeldVerticesStayOnTheirPathThroughMovesAndRemeshing) {
  test::CubeFrame cube = test::cube_frame(4);
  // Remeshing renumbers: the ones that are held are known again by a mark that travels along.
  auto number = cube.mesh.add_vertex_attribute<int>(-1);
  std::vector<Vec3> path;
  for (Vertex v : cube.frame) {
    number[v] = static_cast<int>(path.size());
    path.push_back(cube.mesh.position(v));
  }
  const double h = 0.6 * mean_edge_length(cube.mesh);
  SurfaceTracker tracker(std::move(cube.mesh), {.resolution = h});
  for (Vertex v : cube.frame) tracker.held()[v] = Hold::all;
  std::size_t operations = 0;
  for (int step = 0; step < 30; ++step) {
    std::vector<Vec3> predicted = positions_of(tracker.mesh());
    for (Vertex v : tracker.mesh().vertices()) {
      Vec3& x = predicted[v.index()];
      if (is_held(tracker.held()[v])) {  // the frame turns about z and rises
        x += 0.1 * h * Vec3(-0.3 * x.y(), 0.3 * x.x(), 0.1);
        path[static_cast<std::size_t>(number[v])] = x;
      } else {  // the films flutter
        x += 0.15 * h * Vec3(std::sin(3 * x.y() + step), std::sin(3 * x.z()), std::cos(3 * x.x() - step));
      }
    }
    ASSERT_EQ(tracker.advance(predicted).fraction, 1);
    operations += tracker.remesh().done_in_all();
    std::size_t found = 0;
    for (Vertex v : tracker.mesh().vertices())
      if (number[v] >= 0) {
        ++found;
        EXPECT_TRUE(is_held(tracker.held()[v]));
        EXPECT_EQ(tracker.mesh().position(v), path[static_cast<std::size_t>(number[v])]);
      } else {
        EXPECT_EQ(tracker.held()[v], Hold::none) << "a new vertex is free";
      }
    ASSERT_EQ(found, path.size());
    ASSERT_EQ(audit(tracker.mesh(), {.closed_regions = false}).text(), "clean");
  }
  EXPECT_GT(operations, 100U);
}

// Carries a value through the operations; names stay with the vertices they were given to.
class Carry final : public OperationObserver {
 public:
  explicit Carry(SurfaceMesh& mesh)
      : values(mesh.add_vertex_attribute<double>(0)), name(mesh.add_vertex_attribute<int>(-1)) {}
  void after_split(const SurfaceMesh&, const SplitEvent& e) override {
    values[e.added] = (values[e.ends[0]] + values[e.ends[1]]) / 2;
    ++splits;
  }
  void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
    values[e.kept] = (1 - e.t) * values[e.kept] + e.t * values[e.removed];
    ++collapses;
  }
  VertexAttribute<double> values;
  VertexAttribute<int> name;
  std::size_t splits = 0, collapses = 0;
};

TEST(SurfaceTracker, ClosesManyGapsAndAttributesFollow) {
  SurfaceMesh fine = test::analytic_double_bubble(1, 40);
  const double h = 2 * mean_edge_length(fine);
  SurfaceTracker tracker(std::move(fine), {.resolution = h});
  SurfaceMesh& mesh = tracker.mesh();
  Carry carry(mesh);
  const ObserverToken token = tracker.add_observer(carry);
  const std::vector<Vec3> start = positions_of(mesh);
  for (Vertex v : mesh.vertices()) {
    carry.name[v] = static_cast<int>(v.index());
    carry.values[v] = mesh.position(v).x();
    tracker.held()[v] = v.index() % 7 == 0 ? Hold::all : Hold::none;
  }
  const std::size_t slots = mesh.vertex_slots();
  const RemeshStatistics done = tracker.remesh();
  EXPECT_EQ(done[Operation::split].done, carry.splits);
  EXPECT_EQ(done[Operation::collapse].done, carry.collapses);
  EXPECT_GT(carry.collapses, slots / 5);
  EXPECT_EQ(mesh.vertex_slots(), mesh.vertex_count());
  EXPECT_EQ(mesh.triangle_slots(), mesh.triangle_count());
  EXPECT_LT(mesh.vertex_slots(), slots);
  EXPECT_EQ(audit(mesh).text(), "clean");
  std::size_t held = 0, renumbered = 0;
  for (Vertex v : mesh.vertices()) {
    EXPECT_NEAR(carry.values[v], mesh.position(v).x(), h);
    if (carry.name[v] >= 0) renumbered += carry.name[v] != static_cast<int>(v.index()) ? 1U : 0U;
    if (!is_held(tracker.held()[v])) continue;
    ++held;
    ASSERT_EQ(carry.name[v] % 7, 0);
    EXPECT_EQ(mesh.position(v), start[static_cast<std::size_t>(carry.name[v])]);
    EXPECT_EQ(carry.values[v], mesh.position(v).x());
  }
  EXPECT_EQ(held, (slots + 6) / 7);
  EXPECT_GT(renumbered, 0U);
}

TEST(SurfaceTracker, TellsAnObserverForAsLongAsItsTokenLives) {
  SurfaceMesh fine = test::analytic_double_bubble(1, 24);
  const double h = 2.2 * mean_edge_length(fine);
  SurfaceTracker tracker(std::move(fine), {.resolution = h});
  Carry first(tracker.mesh()), second(tracker.mesh());
  ObserverToken outlives;
  {
    const ObserverToken token = tracker.add_observer(first);
    outlives = tracker.add_observer(second);
    tracker.remesh();
    ASSERT_GT(first.collapses, 0U);
    EXPECT_EQ(first.collapses, second.collapses);
  }
  const std::size_t told = first.collapses;
  for (Vertex v : tracker.mesh().vertices()) tracker.mesh().set_position(v, 0.6 * tracker.mesh().position(v));
  tracker.remesh();
  EXPECT_EQ(first.collapses, told);
  EXPECT_GT(second.collapses, told);
  outlives.remove();
  const std::size_t then = second.collapses;
  for (Vertex v : tracker.mesh().vertices()) tracker.mesh().set_position(v, 0.6 * tracker.mesh().position(v));
  tracker.remesh();
  EXPECT_EQ(second.collapses, then);
}

TEST(SurfaceTracker, IsRestoredWithWhatIsHeldAndSolid) {
  SurfaceTracker tracker = double_bubble_tracker(16);
  SurfaceMesh& mesh = tracker.mesh();
  tracker.held()[Vertex(3)] = Hold::y;
  tracker.solid()[Triangle(4)] = 1;
  SurfaceTracker::State state;
  tracker.save(state);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, 0.5 * mesh.position(v));
  tracker.remesh();
  tracker.held()[Vertex(0)] = Hold::all;
  tracker.restore(state);
  EXPECT_TRUE(test::same_bits(state, tracker.state()));
  EXPECT_EQ(tracker.held()[Vertex(3)], Hold::y);
  EXPECT_EQ(tracker.held()[Vertex(0)], Hold::none);
  EXPECT_EQ(tracker.solid()[Triangle(4)], 1);
  SurfaceTracker other(SurfaceMesh::from_state(state), tracker.options());
  EXPECT_EQ(other.held()[Vertex(3)], Hold::y);
  EXPECT_EQ(other.solid()[Triangle(4)], 1);
}

TEST(SurfaceTracker, LeavesFewGapsAndTheNumberingAlone) {
  SurfaceTracker tracker = double_bubble_tracker(16);
  SurfaceMesh& mesh = tracker.mesh();
  const Vertex dead = mesh.add_vertex(Vec3(9, 9, 9));
  mesh.remove_vertex(dead);
  const auto before = mesh.state();
  EXPECT_EQ(tracker.remesh().done_in_all(), 0U);
  EXPECT_TRUE(test::same_bits(before, mesh.state()));
}

// What a step does to the area is the predicted motion and what each stage adds.
TEST(SurfaceTracker, TellsTheAreaThatEachStageHasMade) {
  SurfaceTracker tracker = double_bubble_tracker(24);
  std::vector<Vec3> predicted = positions_of(tracker.mesh());
  // Two sides that would pass through each other: the move cannot do all of it.
  for (Vec3& x : predicted) x.x() *= 0.9;
  for (Vec3& x : predicted) x *= 1 + 0.05 * std::sin(7 * x.y());
  const double asked = total_area(tracker.mesh(), predicted);
  const TrackerStep done = tracker.step(predicted);
  EXPECT_NEAR(total_area(tracker.mesh()), asked + done.move_area + done.topology_area + done.remesh_area,
              1e-12 * asked);
  EXPECT_NE(done.remesh_area, 0);
  EXPECT_EQ(done.topology_area, 0) << "it is not enabled";
}

}  // namespace
}  // namespace lostopos
