// Scenes whose start is a mesh of the reference program, or made here in its place.
#include "FoamSim/scenes/foam_start.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <sstream>

#include "Base/error.h"
#include "FoamSim/run/start_checks.h"
#include "FoamSim/scenes/scene_memory.h"
#include "LosTopos/io/rec.h"
#include "tests/FoamSim/scenes/start_mesh.h"
#include "tests/support/film_meshes.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

Scene scene_with(const char* name, const std::string& load_dir) {
  Scene scene = built_in_scene(name);
  scene.options.set("load_dir", load_dir, "test");
  return scene;
}

TEST(FoamStart, IsGrownWithFilmsBetweenNeighboursAndTheSameBitsAgain) {
  const SurfaceMesh foam = grown_foam(8, 5);
  EXPECT_EQ(lostopos::audit(foam).text(), "clean");
  EXPECT_EQ(lostopos::regions(foam).size(), 9U);
  EXPECT_GT(lostopos::junction_edge_count(foam), 50U);
  const SurfaceMesh again = grown_foam(8, 5), other = grown_foam(8, 6);
  EXPECT_TRUE(std::ranges::equal(foam.positions(), again.positions()));
  EXPECT_FALSE(std::ranges::equal(foam.positions(), other.positions()));
}

TEST(FoamStart, SaysWhereItComesFrom) {
  const auto notes = [](const Scene& scene) {
    const Simulation simulation = make_simulation(scene);
    return check_start(scene, simulation, {lostopos::closed_region_volumes(simulation.mesh()), Vec3::Zero()});
  };
  Scene grown = built_in_scene("foam");
  grown.options.set("spheres", 3L, "test");
  ASSERT_EQ(notes(grown).size(), 1U);
  EXPECT_NE(notes(grown)[0].find("made of 3 spheres"), std::string::npos) << notes(grown)[0];
  const ::test::ScratchFolder folder;
  write_rec(folder / "mesh001000.rec", from_mesh(lostopos::test::analytic_double_bubble(1, 12)));
  EXPECT_TRUE(notes(scene_with("foam", folder.path().string())).empty());
}

TEST(FoamStart, IsTheMeshInTheFolderAtRest) {
  const ::test::ScratchFolder folder;
  const SurfaceMesh mesh = lostopos::test::analytic_double_bubble(1, 12);
  lostopos::SurfaceData data = from_mesh(mesh);
  data.held.push_back({0, mesh.position(Vertex(0))});
  write_rec(folder / "mesh001000.rec", data);
  const Simulation simulation = make_simulation(scene_with("foam", folder.path().string()));
  EXPECT_TRUE(std::ranges::equal(simulation.mesh().positions(), mesh.positions()));
  EXPECT_EQ(simulation.held()[0], lostopos::Hold::none);
}

TEST(LoadScene, TakesCirculationAndHeldVertices) {
  const ::test::ScratchFolder folder;
  const SurfaceMesh mesh = lostopos::test::analytic_double_bubble(1, 12);
  lostopos::SurfaceData data = from_mesh(mesh);
  data.held.push_back({3, mesh.position(Vertex(3))});
  lostopos::PairArray circulation{lostopos::rec_pair_array, {0}, {}};
  for (Vertex v : mesh.vertices()) {
    const lostopos::Labels pair = mesh.labels(mesh.triangles(v)[0]);
    circulation.values.push_back({std::min(pair.p, pair.q), std::max(pair.p, pair.q), 0.25});
    circulation.offsets.push_back(circulation.values.size());
  }
  data.pair_arrays.push_back(circulation);
  write_rec(folder / "mesh000000.rec", data);
  const Simulation simulation = make_simulation(scene_with("load", folder.path().string()));
  EXPECT_EQ(simulation.held()[3], lostopos::Hold::all);
  EXPECT_EQ(simulation.held()[4], lostopos::Hold::none);
  for (Vertex v : simulation.mesh().vertices()) {
    const lostopos::Labels pair = mesh.labels(mesh.triangles(v)[0]);
    EXPECT_EQ(std::abs(simulation.circulation().get(v, pair)), 0.25);
  }
}

TEST(LoadDir, WithoutTheMeshIsRefusedInOneLine) {
  const ::test::ScratchFolder folder;
  for (const auto& [scene, place, problem] : {std::tuple{"load", std::string(), "it is not set"},
                                              {"load", folder.path().string(), "has no such file"},
                                              {"foam", folder / "nowhere", "there is no folder"},
                                              {"pullingfoam", folder.path().string(), "mesh001000.rec"}}) {
    try {
      make_simulation(scene_with(scene, place));
      ADD_FAILURE() << scene << " took " << place;
    } catch (const base::InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(problem), std::string::npos) << message;
      EXPECT_NE(message.find("load_dir"), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST(FoamStart, OfBubblesIsRelaxed) {
  Scene scene = built_in_scene("foam");
  scene.options.set("bubbles", 12L, "test");
  scene.options.set("relax", 0L, "test");
  const double raw = lostopos::total_area(make_simulation(scene).mesh());
  scene.options.unset("relax");
  std::vector<long> told;
  const Simulation simulation = make_simulation(scene, [&told](long done, long of) {
    EXPECT_EQ(of, 30);
    told.push_back(done);
    return true;
  });
  EXPECT_EQ(told.size(), 30U);
  EXPECT_EQ(lostopos::audit(simulation.mesh()).text(), "clean");
  EXPECT_EQ(lostopos::regions(simulation.mesh()).size(), 13U);
  EXPECT_LT(lostopos::total_area(simulation.mesh()), 0.96 * raw);
  for (const lostopos::RegionVolume& bubble : lostopos::closed_region_volumes(simulation.mesh())) {
    if (bubble.region == lostopos::air) continue;
    EXPECT_GT(bubble.volume, 0.25 * std::numbers::pi / 6);
    EXPECT_LT(bubble.volume, 2 * std::numbers::pi / 6);
  }
}

TEST(FoamStart, CanBeLeftBeforeItIsRelaxed) {
  Scene scene = built_in_scene("foam");
  scene.options.set("bubbles", 4L, "test");
  long told = 0;
  make_simulation(scene, [&told](long, long) { return ++told < 3; });
  EXPECT_EQ(told, 3);
}

TEST(FoamStart, IsOneOfThree) {
  for (const auto& [keys, text] : {std::pair("bubbles=5 spheres=8", "'bubbles' and 'spheres'"),
                                   std::pair("bubbles=5 load_dir=x", "'bubbles' and 'load_dir'"),
                                   std::pair("relaxations=2", "'relaxations' is for")}) {
    Scene scene = built_in_scene("foam");
    std::istringstream words(keys);
    for (std::string word; words >> word;) scene.options.set_assignment(word, "test");
    try {
      build_surface(scene);
      ADD_FAILURE() << keys;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
}

TEST(RelaxedStart, IsForClosedFoamsAtRest) {
  for (const char* name : {"quadjunction-frame", "headon"}) {
    Scene scene = built_in_scene(name);
    scene.options.set("relax", 2L, "test");
    EXPECT_THROW(make_simulation(scene), base::InputError) << name;
  }
  Scene scene = built_in_scene("doublebubble");
  const double area = lostopos::total_area(make_simulation(scene).mesh());
  scene.options.set("relax", 5L, "test");
  EXPECT_LT(lostopos::total_area(make_simulation(scene).mesh()), area);
}

TEST(SceneMemory, IsEstimatedForEveryBuiltInShape) {
  for (const SceneEntry& entry : built_in_catalogue()->scenes) {
    if (!entry.triangles || entry.name == "foam") continue;  // a foam of no bubbles is grown
    const Scene scene = built_in_scene(entry.name);
    const auto size = estimated_size(scene);
    ASSERT_TRUE(size) << entry.name;
    const auto triangles = static_cast<double>(build_surface(scene).triangle_count());
    EXPECT_GT(size->triangles, 0.8 * triangles) << entry.name;
    EXPECT_LT(size->triangles, 6 * triangles) << entry.name;
  }
}

TEST(SceneMemory, IsEstimatedWhereUsersGiveANumberOfBubbles) {
  Scene scene = built_in_scene("foam");
  scene.options.set("bubbles", 12L, "test");
  const auto small = estimated_size(scene);
  ASSERT_TRUE(small);
  const double triangles = static_cast<double>(make_simulation(scene).mesh().triangle_count());
  EXPECT_GT(small->triangles, 0.5 * triangles);
  EXPECT_LT(small->triangles, 2 * triangles);
  EXPECT_NO_THROW(lostopos::require_memory(*small, 1e9));
  scene.options.set("bubbles", 1'000'000L, "test");
  const auto large = estimated_size(scene);
  ASSERT_TRUE(large);
  EXPECT_GT(large->bytes, 1e10);
  try {
    lostopos::require_memory(*large, 1e9);
    ADD_FAILURE();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("1 GB"), std::string::npos) << error.what();
  }
}

TEST(PullingFoam, IsHeldByTwoFlatCircles) {
  const test::StartMesh start("pullingfoam");
  for (int side : {-1, 1}) {
    std::vector<Vec3> ring;
    for (Vertex v : start.held())
      if (side * start.mesh().position(v).x() > side * 0.5) ring.push_back(start.mesh().position(v));
    ASSERT_GE(ring.size(), 8U);
    Vec3 centre = Vec3::Zero();
    // Any three points of a circle tell its centre: where their bisecting planes and their own plane meet.
    Eigen::Matrix3d planes;
    const Vec3 a = ring[1] - ring[0], b = ring[2] - ring[0];
    planes << a.transpose(), b.transpose(), a.cross(b).transpose();
    centre = ring[0] + planes.inverse() * Vec3(a.squaredNorm() / 2, b.squaredNorm() / 2, 0);
    const Vec3 normal = a.cross(b).normalized();
    for (const Vec3& x : ring) {
      EXPECT_NEAR(normal.dot(x - centre), 0, 1e-10);
      EXPECT_NEAR((x - centre).norm(), (ring[0] - centre).norm(), 1e-10);
    }
  }
}

}  // namespace
}  // namespace foamsim
