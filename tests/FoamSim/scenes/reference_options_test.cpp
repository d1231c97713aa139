// The keys of the reference program's option files: one table, and what each value becomes.
#include "FoamSim/scenes/reference_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "Base/error.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

using lostopos::KeyUse;
using lostopos::ReferenceKey;
using ::test::ScratchFolder;

// A scene from a file with these lines.
Scene read(const std::string& lines, const ScratchFolder& scratch = ScratchFolder()) {
  std::ofstream(scratch / "options.txt") << lines;
  return read_reference_options(scratch / "options.txt", built_in_catalogue());
}

std::string refusal(const std::string& lines) {
  try {
    read(lines);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "no error";
}

bool has_note(const Scene& scene, const std::string& text) {
  return std::ranges::any_of(scene.notes,
                             [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

TEST(ReferenceKeys, AreThoseOfTheReferenceEachWithAMeaningOrAReason) {
  const std::set<std::string_view> theirs{"scene",
                                          "load-dir",
                                          "time-step",
                                          "simulation-time",
                                          "implicit-integration",
                                          "pbd-implicit",
                                          "RK4-velocity-integration",
                                          "smoothing-coef",
                                          "damping-coef",
                                          "sigma",
                                          "gravity",
                                          "fmmtl",
                                          "looped",
                                          "radius",
                                          "density",
                                          "stretching",
                                          "bending",
                                          "output-mesh",
                                          "output-mesh-every-n-frames",
                                          "output-obj",
                                          "output-obj-every-n-frames",
                                          "remeshing-resolution",
                                          "remeshing-iterations",
                                          "lostopos-collision-epsilon-fraction",
                                          "lostopos-merge-proximity-epsilon-fraction",
                                          "lostopos-perform-smoothing",
                                          "lostopos-max-volume-change-fraction",
                                          "lostopos-min-triangle-angle",
                                          "lostopos-max-triangle-angle",
                                          "lostopos-large-triangle-angle-to-split",
                                          "lostopos-min-triangle-area-fraction",
                                          "lostopos-t1-transition-enabled",
                                          "lostopos-t1-pull-apart-distance-fraction",
                                          "lostopos-smooth-subdivision",
                                          "lostopos-allow-non-manifold",
                                          "lostopos-allow-topology-changes",
                                          "mesh-size-n",
                                          "mesh-size-m",
                                          "foam-burst-interval",
                                          "foam-burst-start"};
  std::set<std::string_view> ours;
  const std::vector<base::OptionSpec> options = all_option_specs(*built_in_catalogue());
  for (const ReferenceKey& key : reference_keys()) {
    EXPECT_TRUE(ours.insert(key.name).second) << key.name << " is there twice";
    EXPECT_EQ(key.use == KeyUse::without, key.ours.empty()) << key.name;
    EXPECT_TRUE(key.use == KeyUse::as_it_is || !key.meaning.empty()) << key.name;
    if (key.use == KeyUse::as_it_is) {
      EXPECT_NE(std::ranges::find(options, key.ours, &base::OptionSpec::key), options.end()) << key.ours;
    }
  }
  EXPECT_EQ(ours, theirs);
}

TEST(ReferenceOptions, TheClockCountsDynamicsAndRemeshingTicks) {
  const Scene scene = read(
      "scene doublebubble\ntime-step 0.02\nsimulation-time 8\nsmoothing-coef 3\ndamping-coef 0.5\nsigma 0.7\n"
      "mesh-size-n 24\nmesh-size-m 30\n");
  EXPECT_EQ(scene.options.number("dt"), 0.02);
  EXPECT_EQ(scene.options.number("time"), 4);
  EXPECT_EQ(scene.options.number("diffusion"), 6);
  EXPECT_EQ(scene.options.number("damping"), 0.5);
  EXPECT_EQ(scene.options.number("sigma"), 0.7);
  EXPECT_EQ(scene.options.whole("n"), 24);
  EXPECT_EQ(scene.options.whole("m"), 30);
  EXPECT_TRUE(contains(scene.options.words("effects"), "damping"));
  EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
}

TEST(ReferenceOptions, WhatIsAbsentIsAsInTheReference) {
  const base::OptionSet options = read("scene doublebubble\n").options;
  EXPECT_EQ(options.number("dt"), 0.01);
  EXPECT_EQ(options.number("time"), 0.5);
  EXPECT_EQ(options.words("effects"), (std::vector<std::string>{"surface_tension", "diffusion"}));
  EXPECT_EQ(options.number("diffusion"), 20);
  EXPECT_EQ(options.number("sigma"), 1);
  EXPECT_EQ(options.word("area"), "averaged");
  EXPECT_EQ(options.word("integrator"), "euler");
  EXPECT_EQ(options.number("resolution"), 0.1);
  EXPECT_EQ(options.whole("remeshing.iterations"), 1);
  EXPECT_EQ(options.number("tracker.proximity"), 1e-4);
  EXPECT_EQ(options.number("topology.merge_distance"), 0.1);
  EXPECT_EQ(options.number("remeshing.smooth_below"), 30);
  EXPECT_FALSE(options.flag("remeshing.butterfly"));
  EXPECT_EQ(options.number("remeshing.max_volume_change"), 1e-2);
  EXPECT_TRUE(options.flag("topology.enabled"));
  EXPECT_TRUE(options.flag("topology.separate"));
  EXPECT_EQ(options.whole("rec_every"), 0);
}

TEST(ReferenceOptions, NoIterationsMeanNeitherRemeshingNorTopology) {
  const Scene scene = read("scene barrel\nremeshing-iterations 0\nlostopos-allow-topology-changes 1\n");
  EXPECT_FALSE(scene.options.flag("remeshing.enabled"));
  EXPECT_FALSE(scene.options.flag("topology.enabled"));
  EXPECT_TRUE(has_note(scene, "remeshing-iterations is 0"));
  EXPECT_EQ(read("scene cube\nremeshing-iterations 3\n").options.whole("remeshing.iterations"), 3);
}

TEST(ReferenceOptions, AResolutionOfNothingIsTheMeanOfTrianglesSides) {
  const Scene scene = read("scene doublebubble\nremeshing-resolution 0\nmesh-size-n 16\nmesh-size-m 16\n");
  const Simulation simulation = make_simulation(scene);
  double sum = 0;
  for (lostopos::Triangle t : simulation.mesh().triangles()) {
    const auto& [a, b, c] = simulation.mesh().vertices(t);
    const auto side = [&](lostopos::Vertex u, lostopos::Vertex v) {
      return (simulation.mesh().position(u) - simulation.mesh().position(v)).norm();
    };
    sum += side(a, b) + side(b, c) + side(c, a);
  }
  EXPECT_NEAR(simulation.resolution(), sum / static_cast<double>(3 * simulation.mesh().triangle_count()), 1e-12);
}

TEST(ReferenceOptions, OutputsAreCountedInTicks) {
  const auto every = [](const std::string& interval) {
    return read("scene cube\noutput-mesh 1\noutput-mesh-every-n-frames " + interval + "\n").options.whole("rec_every");
  };
  EXPECT_EQ(every("0"), 1);
  EXPECT_EQ(every("100"), 50);
  EXPECT_EQ(every("5"), 5);
  EXPECT_EQ(read("scene cube\noutput-mesh-every-n-frames 4\n").options.whole("rec_every"), 0);
  const Scene scene = read("scene cube\noutput-obj 1\noutput-obj-every-n-frames 7\n");
  EXPECT_EQ(scene.options.whole("obj_every"), 7);
  EXPECT_TRUE(has_note(scene, "'output-obj-every-n-frames' is odd"));
}

TEST(ReferenceOptions, IntegratorsAreChosenAndRK4IsExplained) {
  const Scene rk4 = read("scene cube\nRK4-velocity-integration 1\n");
  EXPECT_EQ(rk4.options.word("integrator"), "rk4");
  EXPECT_TRUE(has_note(rk4, "in the reference it has no effect"));
  const Scene pbd = read("scene cube\npbd-implicit 1\n");
  EXPECT_EQ(pbd.options.word("integrator"), "euler");
  EXPECT_TRUE(has_note(pbd, "no effect without implicit-integration"));
}

// What the command line sets comes after the file.
TEST(ReferenceOptions, ConservativeDynamicsLeaveOutTheirDiffusion) {
  Scene scene = read("scene cube\nmesh-size-n 1\nsmoothing-coef 10\nremeshing-resolution 0\n");
  scene.options.set_assignment("dynamics=conservative", "--set");
  EXPECT_NO_THROW(validate(scene));
  EXPECT_FALSE(contains(effects_of(scene.options), "diffusion"));
  Simulation simulation = make_simulation(scene);
  EXPECT_NO_THROW(simulation.step());
}

TEST(ReferenceOptions, WhatMeansNothingIsSaid) {
  const Scene scene = read("scene cube\nsigma 1\ngravity 9.8\nradius 0.003\nfoam-burst-start 3\nload-dir x\n");
  for (const char* text : {":3: 'gravity' means nothing in the scene cube", ":4: 'radius' means nothing",
                           ":5: 'foam-burst-start'", ":6: 'load-dir'"})
    EXPECT_TRUE(has_note(scene, text)) << text;
  EXPECT_EQ(scene.notes.size(), 4u);
}

TEST(ReferenceOptions, FastMultipolesAreTreesWhereThereAreManyTriangles) {
  EXPECT_EQ(read("scene cube\n").options.word("velocity"), "auto");
  EXPECT_EQ(read("scene cube\nfmmtl 1\n").options.word("velocity"), "auto");
  EXPECT_EQ(read("scene cube\nfmmtl 0\n").options.word("velocity"), "direct");
}

TEST(ReferenceOptions, BadInputIsALineWithItsPlace) {
  EXPECT_NE(refusal("scene cube\nsigm 1\n").find("options.txt:2: unknown key 'sigm'; did you mean 'sigma'"),
            std::string::npos)
      << refusal("scene cube\nsigm 1\n");
  EXPECT_NE(refusal("scene cbue\n").find("options.txt:1: unknown scene 'cbue'"), std::string::npos);
  EXPECT_NE(refusal("scene cube\n\ntime-step slow\n").find("options.txt:3"), std::string::npos);
  EXPECT_NE(refusal("scene cube\nsigma 1 2\n").find("options.txt:2: one value"), std::string::npos);
  EXPECT_NE(refusal("sigma 1\n").find("needs a line 'scene NAME'"), std::string::npos);
  EXPECT_NE(refusal("scene cube\nremeshing-iterations -1\n").find("options.txt:2"), std::string::npos);
  EXPECT_NE(refusal("scene cube\nsmoothing-coef -1\n").find("options.txt:2: smoothing-coef has to be >= 0"),
            std::string::npos);
  EXPECT_NE(refusal("scene cube\nsmoothing-coef much\n").find("options.txt:2: smoothing-coef"), std::string::npos);
}

}  // namespace
}  // namespace foamsim
