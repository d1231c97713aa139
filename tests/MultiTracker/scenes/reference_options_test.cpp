// The reference tracker's option files, and the meshes beside them.
#include "MultiTracker/scenes/reference_options.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "Base/error.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/shapes/solids.h"
#include "tests/MultiTracker/tracking_checks.h"
#include "tests/support/scratch_folder.h"

namespace multitracker {
namespace {

using lostopos::KeyUse;
using ::test::ScratchFolder;

ReferenceScene read(const std::string& lines, const ScratchFolder& scratch = ScratchFolder()) {
  std::ofstream(scratch / "options.txt") << lines;
  return read_reference_options(scratch / "options.txt");
}

std::string refusal(const std::string& lines) {
  try {
    read(lines);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TrackerOptionFiles, EveryKeyHasAMeaningOrAReason) {
  std::set<std::string_view> names;
  const base::OptionSet options = options_of(scene_by_name("mcf"));
  for (const lostopos::ReferenceKey& key : reference_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name << " is there twice";
    EXPECT_EQ(key.use == KeyUse::without, key.ours.empty()) << key.name;
    EXPECT_TRUE(key.use == KeyUse::as_it_is || !key.meaning.empty()) << key.name;
    if (key.use == KeyUse::as_it_is) {
      EXPECT_TRUE(options.has(key.ours)) << key.ours;
    }
  }
}

TEST(TrackerOptionFiles, SetTheScenesOptions) {
  const ReferenceScene mcf = read(
      "scene mcf\ntime-step 0.5 # large\nsimulation-time 46\nremeshing-resolution 0.05\nlostopos-perform-smoothing 1\n"
      "lostopos-min-triangle-angle 5\noutput-mesh 1\noutput-mesh-every-n-frames 10\n");
  EXPECT_EQ(mcf.scene->name, "mcf");
  EXPECT_EQ(mcf.options.number("dt"), 0.5);
  EXPECT_EQ(mcf.options.whole("steps"), 26);  // 12 to the time 6, 12 of 2 to 30, 2 of 8 to 46
  EXPECT_EQ(mcf.options.word("flow"), "area-gradient");
  EXPECT_TRUE(mcf.options.flag("faster_later"));
  EXPECT_EQ(mcf.options.number("resolution"), 0.05);
  EXPECT_EQ(mcf.options.number("remeshing.smooth_below"), 60);
  EXPECT_EQ(mcf.options.number("remeshing.min_angle"), 5);
  EXPECT_EQ(mcf.options.whole("rec_every"), 10);
  EXPECT_EQ(mcf.options.number("topology.merge_distance"), 0.02);
  EXPECT_TRUE(mcf.mesh_file.empty());
  EXPECT_TRUE(mcf.notes.empty());
  const ReferenceScene enright = read("scene enright\ntime-step 0.03\nsimulation-time 3\nmesh-size-n 4\n");
  EXPECT_EQ(enright.options.whole("period_steps"), 100);
  EXPECT_EQ(enright.options.whole("steps"), 100);
  ASSERT_EQ(enright.notes.size(), 1u);
  EXPECT_NE(enright.notes[0].find("options.txt:4: 'mesh-size-n' has no meaning here"), std::string::npos);
  const ReferenceScene noise = read("scene noise\nlostopos-allow-topology-changes 0\nlostopos-allow-non-manifold 0\n");
  EXPECT_FALSE(noise.options.flag("topology.enabled"));
}

TEST(TrackerOptionFiles, TakeTheMeshBesideThem) {
  const ScratchFolder scratch;
  lostopos::write_arec(scratch.path() / "noise.arec", lostopos::from_mesh(lostopos::icosphere(1, 0.2)));
  const ReferenceScene noise = read("scene noise\n", scratch);
  EXPECT_EQ(noise.mesh_file, scratch / "noise.arec");
}

TEST(TrackerOptionFiles, BadInputIsALineWithItsPlace) {
  EXPECT_NE(refusal("scene mcf\ntime-stp 1\n").find("options.txt:2: unknown key 'time-stp'"), std::string::npos);
  EXPECT_NE(refusal("scene mfc\n").find("options.txt:1: unknown scene"), std::string::npos);
  EXPECT_NE(refusal("scene mcf\ntime-step 0\n").find("options.txt:2: time-step has to be > 0"), std::string::npos);
  EXPECT_NE(refusal("time-step 1\n").find("needs a line 'scene NAME'"), std::string::npos);
}

// A long integer does not hold them.
TEST(TrackerOptionFiles, MoreStepsThanCanBeCountedAreRefused) {
  for (const char* lines :
       {"scene mcf\ntime-step 1e-300\nsimulation-time 1\n", "scene mcf\ntime-step 1\nsimulation-time 1e300\n",
        "scene noise\ntime-step 1\nsimulation-time inf\n", "scene enright\ntime-step 1e-300\nsimulation-time 1e-290\n"})
    EXPECT_NE(refusal(lines).find("steps; at most 1e+15 are possible"), std::string::npos) << lines;
}

}  // namespace
}  // namespace multitracker
