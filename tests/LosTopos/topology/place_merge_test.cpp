#include "LosTopos/topology/place_merge.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/topology/near_pairs.h"
#include "LosTopos/topology/sectors.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

struct Fixture {
  explicit Fixture(SurfaceMesh m)
      : mesh(std::move(m)),
        held(mesh.add_vertex_attribute<Hold>(Hold::none)),
        context(mesh, held, test::wide_bounds()) {}
  SurfaceMesh mesh;
  VertexAttribute<Hold> held;
  RemeshContext context;
};

std::array<Site, 2> nearest_places(const SurfaceMesh& mesh, double distance) {
  const auto pairs = near_pairs(mesh, distance);
  const NearPair& near = pairs.front();
  if (near.pair.kind == ElementPair::Kind::vertex_triangle)
    return {site_at(mesh, Vertex(near.pair.first)),
            site_in(mesh, Triangle(near.pair.second), {near.weights[1], near.weights[2], near.weights[3]})};
  return {site_on(mesh, Edge(near.pair.first), near.weights[1]),
          site_on(mesh, Edge(near.pair.second), near.weights[3])};
}

// Records what an observer sees.
class Recorder final : public OperationObserver {
 public:
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& event) override {
    triangles_before = mesh.triangle_count();
    point = Vec3::Zero();
    for (std::size_t k = 0; k < 2; ++k) {
      Vec3 place = Vec3::Zero();
      for (std::size_t i = 0; i < event.places[k].count; ++i)
        place += event.places[k].weights[i] * mesh.position(event.places[k].vertices[i]);
      point += (k == 0 ? 1 - event.t : event.t) * place;
    }
  }
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& event) override {
    ++merges;
    result = event.result;
    position = mesh.alive(event.result) ? mesh.position(event.result) : event.position;
  }
  int merges = 0;
  std::size_t triangles_before = 0;
  Vec3 point = Vec3::Zero(), position = Vec3::Zero();
  Vertex result;
};

TEST(PlaceMerge, TwoSpheresTouchAtOneVertex) {
  SurfaceMesh mesh = test::two_spheres(2, 0.05, Region(1), Region(2));
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  Recorder recorder;
  const std::array<OperationObserver*, 1> observers = {&recorder};
  RemeshContext context(mesh, held, test::wide_bounds(), observers);
  const auto volumes = region_volumes(mesh);
  const auto [a, b] = nearest_places(mesh, 0.2);
  PlaceMerge merge(context);
  ASSERT_EQ(merge.attempt(a, b, {}), std::nullopt);
  EXPECT_EQ(audit(mesh).text(), "clean");
  EXPECT_EQ(euler_characteristic(mesh), 3);  // two spheres with one point in common
  EXPECT_FALSE(is_complete(mesh, merge.result()));
  EXPECT_EQ(recorder.merges, 1);
  EXPECT_LT((recorder.point - recorder.position).norm(), 1e-15);
  for (std::size_t i = 0; i < volumes.size(); ++i) EXPECT_NEAR(region_volumes(mesh)[i].volume, volumes[i].volume, 0.05);
}

TEST(PlaceMerge, CoincidentTrianglesBecomeOneWall) {
  SurfaceMesh mesh = test::corner_tetrahedron_pair(0.1);
  const double outer = test::film_area(mesh, Region(1), air);
  Fixture f(std::move(mesh));
  PlaceMerge merge(f.context);
  // Vertices 0-2 face 4-6 across the gap.
  std::size_t cancelled = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(merge.attempt(site_at(f.mesh, Vertex(i)), site_at(f.mesh, Vertex(i + 4)), {}), std::nullopt) << i;
    cancelled += merge.cancelled();
    EXPECT_EQ(audit(f.mesh).text(), "clean");
  }
  EXPECT_EQ(cancelled, 1u);
  EXPECT_EQ(f.mesh.triangle_count(), 7u);
  EXPECT_GT(test::film_area(f.mesh, Region(1), Region(2)), 0.4);
  EXPECT_LT(test::film_area(f.mesh, Region(1), air), outer);
  EXPECT_EQ(euler_characteristic(f.mesh), 3);  // two balls that share a disc
}

TEST(PlaceMerge, SidesOfOneRegionOpenAChannel) {
  Fixture f(test::corner_tetrahedron_pair(0.1, Region(1), Region(1)));
  PlaceMerge merge(f.context);
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_EQ(merge.attempt(site_at(f.mesh, Vertex(i)), site_at(f.mesh, Vertex(i + 4)), {}), std::nullopt);
  EXPECT_EQ(merge.cancelled(), 2u);
  EXPECT_EQ(audit(f.mesh).text(), "clean");
  EXPECT_EQ(euler_characteristic(f.mesh), 2);
  EXPECT_TRUE(test::all_complete(f.mesh));
}

TEST(PlaceMerge, RefusesWhatIsInTheWayAndLeavesEveryBit) {
  SurfaceMesh mesh = test::two_spheres(1, 0.2, Region(1), Region(2));
  test::add_pebble(mesh, {0, 0, 0}, 0.02, air);
  Fixture f(std::move(mesh));
  // The two poles that face each other, with the pebble between them.
  Vertex left, right;
  for (Vertex v : f.mesh.vertices()) {
    const Vec3& x = f.mesh.position(v);
    if (x[0] < -0.05 && (!left.valid() || x[0] > f.mesh.position(left)[0])) left = v;
    if (x[0] > 0.05 && (!right.valid() || x[0] < f.mesh.position(right)[0])) right = v;
  }
  const auto before = f.mesh.state();
  EXPECT_EQ(PlaceMerge(f.context).attempt(site_at(f.mesh, left), site_at(f.mesh, right), {}), Refusal::intersection);
  EXPECT_TRUE(test::same_bits(before, f.mesh.state()));
  f.held[left] = f.held[right] = Hold::all;
  EXPECT_EQ(PlaceMerge(f.context).attempt(site_at(f.mesh, left), site_at(f.mesh, right), {}), Refusal::held);
  EXPECT_TRUE(test::same_bits(before, f.mesh.state()));
}

TEST(PlaceMerge, HeldVerticesStay) {
  Fixture f(test::corner_tetrahedron_pair(0.1));
  const Vec3 place = f.mesh.position(Vertex(4));
  f.held[Vertex(4)] = Hold::all;
  PlaceMerge merge(f.context);
  ASSERT_EQ(merge.attempt(site_at(f.mesh, Vertex(0)), site_at(f.mesh, Vertex(4)), {}), std::nullopt);
  EXPECT_EQ(merge.result(), Vertex(4));
  EXPECT_EQ(f.mesh.position(Vertex(4)), place);
}

}  // namespace
}  // namespace lostopos
