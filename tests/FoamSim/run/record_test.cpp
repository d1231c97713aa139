// What a run leaves for the reference program: read again, it is the simulation that wrote it.
#include <gtest/gtest.h>

#include <fstream>

#include "FoamSim/run/run.h"
#include "FoamSim/run/scene_motion.h"
#include "LosTopos/io/rec.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

namespace fs = std::filesystem;
using ::test::ScratchFolder;

// The meshes of a run of the option file, every `frames` ticks.
fs::path run_of(const ScratchFolder& scratch, const std::string& lines, long steps) {
  std::ofstream(scratch / "options.txt") << lines;
  fs::path out = scratch.path() / "out";
  RunSettings settings;
  settings.out = out;
  settings.stop.steps = steps;
  run_scene(load_scene(scratch / "options.txt"), settings);
  return out;
}

TEST(Record, HasTheCirculationAndWhatIsHeld) {
  const ScratchFolder scratch;
  const fs::path out = run_of(scratch,
                              "scene constrainedsphere\nmesh-size-n 2\nremeshing-resolution 0\noutput-mesh 1\n"
                              "output-mesh-every-n-frames 4\noutput-obj 1\noutput-obj-every-n-frames 8\n",
                              4);
  for (const char* file : {"rec/mesh000000.rec", "rec/mesh000004.rec", "rec/mesh000008.rec", "obj/mesh000000.obj",
                           "obj/mesh000008.obj", "frames/frame_000004.ply"})
    EXPECT_TRUE(fs::exists(out / file)) << file;
  EXPECT_FALSE(fs::exists(out / "obj/mesh000004.obj"));

  SceneMotion motion(SceneMotion::beginning_of(load_scene(scratch / "options.txt")));
  for (int i = 0; i < 4; ++i) motion.step();
  const lostopos::SurfaceData read = lostopos::read_rec(out / "rec/mesh000008.rec");
  EXPECT_EQ(read.positions.size(), motion.mesh().vertex_count());
  const lostopos::PairArray* circulation = find_pair_array(read, lostopos::rec_pair_array);
  ASSERT_NE(circulation, nullptr);
  std::size_t number = 0, held = 0;
  double largest = 0;
  for (lostopos::Vertex v : motion.mesh().vertices()) {
    EXPECT_EQ(read.positions[number], motion.mesh().position(v));
    for (const lostopos::PairValue& value : circulation->at(number)) {
      EXPECT_EQ(value.value, motion.simulation().circulation().get(v, {value.p, value.q}));
      largest = std::max(largest, std::abs(value.value));
    }
    held += lostopos::is_held(motion.simulation().held()[v.index()]) ? 1 : 0;
    ++number;
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_GT(held, 0u);
  EXPECT_EQ(read.held.size(), held);
}

TEST(Record, IsWhatTheSceneLoadGoesOnFrom) {
  const ScratchFolder scratch;
  const fs::path out = run_of(scratch,
                              "scene doublebubble\nmesh-size-n 8\nmesh-size-m 8\nremeshing-iterations 0\n"
                              "remeshing-resolution 0\noutput-mesh 1\n",
                              3);
  fs::copy_file(out / "rec/mesh000006.rec", scratch.path() / "mesh000000.rec");
  std::ofstream(scratch / "load.txt") << "scene load\nload-dir .\nremeshing-iterations 0\nremeshing-resolution 0\n";
  const SceneMotion loaded(SceneMotion::beginning_of(load_scene(scratch / "load.txt")));
  SceneMotion motion(SceneMotion::beginning_of(load_scene(scratch / "options.txt")));
  for (int i = 0; i < 3; ++i) motion.step();
  double largest = 0;
  for (lostopos::Vertex v : motion.mesh().vertices())
    for (const PairCirculation& pair : motion.simulation().circulation().at(v)) {
      EXPECT_EQ(loaded.simulation().circulation().get(v, {pair.pair.low, pair.pair.high}), pair.value);
      largest = std::max(largest, std::abs(pair.value));
    }
  EXPECT_GT(largest, 0.01);
  EXPECT_EQ(loaded.mesh().triangle_count(), motion.mesh().triangle_count());
}

}  // namespace
}  // namespace foamsim
