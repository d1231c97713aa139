// What the frames of a run say of its surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "FoamSim/run/run.h"
#include "FoamSim/run/scene_motion.h"
#include "LosTopos/io/film_faces.h"
#include "LosTopos/io/ply.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

namespace fs = std::filesystem;
using lostopos::SurfaceData;
using ::test::ScratchFolder;

fs::path run_of(const Scene& scene, const fs::path& out, long steps, const fs::path& resume = {}) {
  RunSettings settings;
  settings.out = out;
  settings.stop.steps = steps;
  settings.resume = resume;
  run_scene(scene, settings);
  return out;
}

SurfaceData frame_of(const fs::path& run, long step) {
  const std::string number = std::to_string(step);
  return lostopos::read_ply(run / "frames" / ("frame_" + std::string(6 - number.size(), '0') + number + ".ply"));
}

// A scene with T1s in its first steps.
Scene foam_in_motion() {
  Scene scene = built_in_scene("foam");
  scene.options.set_text("bubbles", "6", "test");
  scene.options.set_text("seed", "3", "test");
  scene.options.set_text("relax", "0", "test");
  scene.options.set_text("frame_every", "1", "test");
  scene.options.set_text("frame_motion", "true", "test");
  return scene;
}

std::vector<std::int32_t> ids_of(const SurfaceData& frame) {
  const lostopos::DataArray* array = lostopos::find_array(frame.vertex_arrays, lostopos::vertex_id_array);
  std::vector<std::int32_t> ids;
  if (array != nullptr)
    for (const double value : array->values) ids.push_back(static_cast<std::int32_t>(value));
  return ids;
}

TEST(Frames, SayWhatIsSolid) {
  const ScratchFolder scratch;
  const Scene scene = built_in_scene("bubblewand");
  const SurfaceData frame = frame_of(run_of(scene, scratch.path() / "out", 0), 0);
  const SceneMotion motion(SceneMotion::beginning_of(scene));
  std::size_t solid = 0;
  for (lostopos::Triangle t : motion.mesh().triangles()) solid += motion.simulation().solid()[t.index()] != 0 ? 1 : 0;
  ASSERT_GT(solid, 0u);
  const std::vector<std::uint8_t> said = lostopos::solid_triangles(frame);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(said, 1)), solid);
}

TEST(Frames, HaveNothingOfTheMotionUnlessAsked) {
  const ScratchFolder scratch;
  Scene scene = foam_in_motion();
  scene.options.set_text("frame_motion", "false", "test");
  EXPECT_TRUE(frame_of(run_of(scene, scratch.path() / "out", 1), 1).vertex_arrays.empty());
}

// Whatever is split, joined and parted: a vertex that goes on has its number, and no other ever gets it.
TEST(Frames, NumbersOfVerticesLast) {
  const ScratchFolder scratch;
  const fs::path out = run_of(foam_in_motion(), scratch.path() / "out", 8);
  std::map<std::int32_t, long> last_seen;
  std::int32_t largest = -1;
  std::size_t came = 0, went = 0;
  for (long step = 0; step <= 8; ++step) {
    const std::vector<std::int32_t> ids = ids_of(frame_of(out, step));
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), ids.size());
    std::int32_t largest_here = largest;
    for (const std::int32_t id : ids) {
      ASSERT_GE(id, 0);
      largest_here = std::max(largest_here, id);
      const auto seen = last_seen.find(id);
      if (seen == last_seen.end()) {
        EXPECT_GT(id, largest) << "a number that was given before";
        ++came;
      } else {
        EXPECT_EQ(seen->second, step - 1) << "a vertex that was gone";
      }
      last_seen[id] = step;
    }
    largest = largest_here;
  }
  for (const auto& [id, step] : last_seen) went += step < 8 ? 1 : 0;
  EXPECT_GT(came, ids_of(frame_of(out, 0)).size());
  EXPECT_GT(went, 0u);
}

TEST(Frames, GoOnWithTheSameNumbersBehindACheckpoint) {
  const ScratchFolder scratch;
  const Scene scene = foam_in_motion();
  const fs::path whole = run_of(scene, scratch.path() / "whole", 6);
  const fs::path parted = run_of(scene, scratch.path() / "parted", 3);
  run_of(scene, parted, 6, parted);
  for (const long step : {3, 4, 6}) EXPECT_EQ(frame_of(parted, step), frame_of(whole, step)) << step;
}

// Where nothing is remeshed: from one frame to the next each vertex goes as far as its velocity says.
TEST(Frames, VelocitiesAreThoseOfTheLastStep) {
  const ScratchFolder scratch;
  for (const char* topology : {"true", "false"}) {
    Scene scene = built_in_scene("doublebubble");
    for (const auto& [key, value] : std::map<std::string, std::string>{{"n", "12"},
                                                                       {"remeshing.enabled", "false"},
                                                                       {"topology.enabled", topology},
                                                                       {"frame_every", "1"},
                                                                       {"frame_motion", "true"}})
      scene.options.set_text(key, value, "test");
    const fs::path out = run_of(scene, scratch.path() / topology, 2);
    const SurfaceData before = frame_of(out, 1), after = frame_of(out, 2);
    ASSERT_EQ(ids_of(before), ids_of(after));
    const lostopos::DataArray* velocity = lostopos::find_array(after.vertex_arrays, lostopos::velocity_array);
    ASSERT_NE(velocity, nullptr);
    const double dt = scene.options.number("dt");
    double largest = 0;
    for (std::size_t v = 0; v < after.positions.size(); ++v) {
      const lostopos::Vec3 u(velocity->values[3 * v], velocity->values[3 * v + 1], velocity->values[3 * v + 2]);
      EXPECT_LT((after.positions[v] - before.positions[v] - dt * u).norm(), 1e-12);
      largest = std::max(largest, u.norm());
    }
    EXPECT_GT(largest, 0.01);
  }
}

}  // namespace
}  // namespace foamsim
