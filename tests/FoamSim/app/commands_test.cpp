#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "FoamSim/effects/registry.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/scene_registry.h"
#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(RunCommand, WritesTheFolderAsDescribed) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim(
      "run doublebubble --steps 4 --set frame_every=2 --set vtp=true --area naive --seed 7 --threads 1 --out " +
      (scratch / "run"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto metrics = lines_of(read_file(scratch / "run/metrics.csv"));
  ASSERT_EQ(metrics.size(), 6u);  // header, start, four steps
  EXPECT_TRUE(metrics[0].starts_with(
      "step,time,vertices,triangles,regions,area,energy,impulse_x,impulse_y,impulse_z,centroid_x,centroid_y,centroid_z,"
      "angle_rms_deg,angle_outer_mean_deg,volume_drift_max,triangle_angle_min_deg,t1_count,snap_count,step_seconds"));
  EXPECT_TRUE(metrics[1].starts_with("0,0,435,880,3,")) << metrics[1];
  EXPECT_TRUE(metrics[5].starts_with("4,0.04,")) << metrics[5];
  EXPECT_EQ(lines_of(read_file(scratch / "run/volumes.csv")).size(), 1u + 5 * 3);
  for (const char* frame : {"frame_000000.ply", "frame_000002.ply", "frame_000004.ply"})
    EXPECT_TRUE(fs::exists(scratch.path() / "run/frames" / frame)) << frame;
  EXPECT_TRUE(fs::exists(scratch.path() / "run/surface.pvd"));
  EXPECT_TRUE(fs::exists(scratch.path() / "run/vtp/frame_000004.vtp"));
  const json run = json::parse(read_file(scratch / "run/run.json"));
  EXPECT_EQ(run["ended"], "finished");
  EXPECT_EQ(run["options"]["area"], "naive");
  EXPECT_EQ(run["seed"], 7);
  EXPECT_EQ(run["threads"], 1);
  EXPECT_EQ(run["last_step"], 4);
  EXPECT_NE(run["command"].get<std::string>().find("--area naive"), std::string::npos);
}

TEST(RunCommand, ExplainNamesActiveEffectsOnly) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim(
      "run sphere --set n=1 --set effects=surface_tension,damping --set damping=0.5 --steps 3 --explain --out " +
      (scratch / "run"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("damping"), std::string::npos);
  EXPECT_EQ(result.out.find("diffusion"), std::string::npos);
}

TEST(RunCommand, ExplainNamesConstraintsWhereThereAreSome) {
  const auto stages = [](const std::string& scene) {
    const ScratchFolder scratch;
    const ProgramResult result = run_foamsim("run " + scene + " --steps 2 --explain --out " + (scratch / "run"));
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result.out.substr(std::min(result.out.find("stage "), result.out.size()));
  };
  const std::string bubbles = stages("doublebubble --set n=8"), straw = stages("straw");
  for (const char* absent : {"\nframe", "\nwire", "\nrod", "\nblow"})
    EXPECT_EQ(bubbles.find(absent), std::string::npos) << absent;
  for (const char* present : {"\nwire", "\nblow"}) EXPECT_NE(straw.find(present), std::string::npos) << present;
}

TEST(RunCommand, QuietPrintsNothing) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim("run sphere --set n=1 --steps 3 --quiet --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.error, "");
}

TEST(RunCommand, EveryBuiltInSceneRuns) {
  for (const SceneEntry& scene : built_in_scenes()) {
    if (scene.mesh_file) continue;  // needs a mesh: LoadScene
    const ScratchFolder scratch;
    const ProgramResult result =
        run_foamsim("run " + std::string(scene.name) + " --steps 3 --out " + (scratch / "run"));
    EXPECT_EQ(result.exit_code, 0) << scene.name << result.error;
  }
}

TEST(RunCommand, TheSameBitsWithOneAndTwoThreadsAndAgain) {
  const ScratchFolder scratch;
  std::string first;
  for (const char* name : {"one --threads 1", "two --threads 2", "again --threads 2"}) {
    const std::string folder = std::string(name).substr(0, std::string(name).find(' '));
    ASSERT_EQ(
        run_foamsim("run doublebubble --set n=24 --steps 25 --out " + scratch.path().string() + "/" + name).exit_code,
        0);
    const std::string frame = read_file(scratch.path() / folder / "frames/frame_000025.ply");
    if (first.empty()) first = frame;
    ASSERT_FALSE(frame.empty());
    EXPECT_TRUE(frame == first) << name;
  }
}

TEST(CompareCommand, MakesATableAndARunEach) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_foamsim("compare doublebubble --areas naive,averaged --steps 3 --no-pictures --out " + (scratch / "c"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(lines_of(read_file(scratch / "c/compare.csv")).size(), 3u);
  EXPECT_TRUE(fs::exists(scratch.path() / "c/naive/run.json"));
  EXPECT_TRUE(fs::exists(scratch.path() / "c/averaged/run.json"));
  const ProgramResult shown = run_foamsim("compare --show " + (scratch / "c"));
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_NE(shown.out.find("averaged"), std::string::npos);
  EXPECT_NE(shown.out.find("of films"), std::string::npos);
}

TEST(CompareCommand, TakesAnOptionOfOneStrategyForItsRow) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim(
      "compare doublebubble --areas averaged,constant-edge --set n=8 --set phi=0.75 --steps 1 --no-pictures --out " +
      (scratch / "c"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto phi = [&scratch](const std::string& area) {
    return nlohmann::json::parse(read_file(scratch / "c" + ("/" + area) + "/run.json"))["options"]["phi"].get<double>();
  };
  EXPECT_EQ(phi("constant-edge"), 0.75);
  EXPECT_EQ(phi("averaged"), 0.5);
}

TEST(ReproduceCommand, DrawsTheStretchedJunctionAndMeasuresTheMeasures) {
  const ScratchFolder scratch;
  for (const std::string what : {"figure3", "measures"}) {
    const ProgramResult result = run_foamsim("reproduce " + what + " --out " + (scratch / "r"));
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_NE(result.out.find("output in"), std::string::npos);
  }
  EXPECT_EQ(lines_of(read_file(scratch / "r/figure3.csv")).size(), 1U + 3 * 4 * 3) << "strategies, stretches, regions";
  EXPECT_EQ(lines_of(read_file(scratch / "r/angle_measures.csv")).size(), 1U + 2 * 4);
  const ProgramResult unknown = run_foamsim("reproduce table2 --out " + (scratch / "u"));
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_FALSE(fs::exists(scratch.path() / "u"));
}

TEST(ListCommands, NameEverythingThereIs) {
  const std::string scenes = run_foamsim("scenes").out, effects = run_foamsim("effects").out;
  for (const SceneEntry& scene : built_in_scenes()) EXPECT_NE(scenes.find(scene.name), std::string::npos) << scene.name;
  for (const EffectEntry& effect : built_in_effects()) EXPECT_NE(effects.find(effect.name), std::string::npos);
  for (const base::OptionSpec& spec : all_option_specs(*built_in_catalogue()))
    EXPECT_NE((scenes + effects).find("  " + spec.key + " "), std::string::npos) << spec.key;
}

TEST(InspectCommand, ReportsCountsVolumesAnglesAndAudit) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --steps 0 --out " + (scratch / "run")).exit_code, 0);
  const ProgramResult result = run_foamsim("inspect --json " + (scratch / "run/frames/frame_000000.ply"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["triangles"], 880);
  EXPECT_EQ(report["euler_characteristic"], 3);
  EXPECT_EQ(report["junction_edges"], 16);
  EXPECT_EQ(report["audit"], "clean");
  // The spheres of the start shape leave the border at 45 and twice 157.5 degrees.
  EXPECT_NEAR(report["angle_rms_film_deg"].get<double>(), std::sqrt((75 * 75 + 2 * 37.5 * 37.5) / 3), 2);
  EXPECT_GT(report["angle_rms_deg"].get<double>(), 40);
  EXPECT_NEAR(report["volumes"]["1"].get<double>(), 4.027, 5e-4);
  EXPECT_NEAR(report["volumes"]["2"].get<double>(), 4.027, 5e-4);
}

// Two tetrahedra, one of which cuts into the other when it is moved by less than its size.
void write_tetrahedra(const std::string& file, double shift) {
  std::ofstream out(file);
  for (const double x : {0.0, shift})
    out << "v " << x << " 0 0\nv " << x + 1 << " 0 0\nv " << x << " 1 0\nv " << x << " 0 1\n";
  for (const int first : {1, 5}) {
    const int a = first, b = first + 1, c = first + 2, d = first + 3;
    out << "g region_" << (first == 1 ? 1 : 2) << "_0\nf " << a << " " << c << " " << b << "\nf " << a << " " << b
        << " " << d << "\nf " << a << " " << d << " " << c << "\nf " << b << " " << c << " " << d << "\n";
  }
}

TEST(InspectCommand, ExitCodeTellsWhetherTheMeshIsClean) {
  const ScratchFolder scratch;
  write_tetrahedra(scratch / "apart.obj", 2);
  write_tetrahedra(scratch / "crossing.obj", 0.3);
  const ProgramResult apart = run_foamsim("inspect " + (scratch / "apart.obj"));
  EXPECT_EQ(apart.exit_code, 0) << apart.out << apart.error;
  for (const char* how : {"inspect ", "inspect --json "}) {
    const ProgramResult crossing = run_foamsim(how + (scratch / "crossing.obj"));
    EXPECT_EQ(crossing.exit_code, 2) << crossing.out << crossing.error;
    EXPECT_NE(crossing.out.find("not clean"), std::string::npos) << crossing.out;
  }
}

TEST(InspectCommand, RepairsAndSaysWhatItDidAndWhatIsLeft) {
  const ScratchFolder scratch;
  // A tetrahedron with vertices of its own for each face, one of them turned.
  std::ofstream(scratch / "broken.obj")
      << "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\n"
         "v 0 0 1\nv 0 1 0\nv 0 0 0\nv 0 0 1\nf 1 3 2\nf 4 5 6\nf 7 8 9\nf 10 11 12\n";
  EXPECT_EQ(run_foamsim("inspect " + (scratch / "broken.obj")).exit_code, 2);
  const ProgramResult mended =
      run_foamsim("inspect " + (scratch / "broken.obj") + " --repair " + (scratch / "mended.ply"));
  EXPECT_EQ(mended.exit_code, 0) << mended.out << mended.error;
  for (const char* done : {"8 vertices were at the place of another", "1 triangle was wound against"})
    EXPECT_NE(mended.out.find(done), std::string::npos) << mended.out;
  EXPECT_EQ(run_foamsim("inspect " + (scratch / "mended.ply")).exit_code, 0);

  write_tetrahedra(scratch / "crossing.obj", 0.3);
  const ProgramResult crossing =
      run_foamsim("inspect --json " + (scratch / "crossing.obj") + " --repair " + (scratch / "still.obj"));
  EXPECT_EQ(crossing.exit_code, 2) << crossing.out;
  const auto report = nlohmann::json::parse(crossing.out);
  EXPECT_TRUE(report.at("repaired").empty());
  EXPECT_NE(report.at("findings").at(0).get<std::string>().find("move them apart"), std::string::npos);

  const ProgramResult nowhere = run_foamsim("inspect " + (scratch / "broken.obj") + " --repair " + (scratch / "x.tex"));
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.error.find("known are .ply"), std::string::npos) << nowhere.error;
}

TEST(CompareCommand, TakesTheSceneBehindAList) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_foamsim("compare --areas averaged,naive sphere --steps 1 --no-pictures --out " + (scratch / "compare"));
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(fs::exists(scratch.path() / "compare/naive/run.json"));
}

TEST(GenerateCommand, PrintsScriptsThatNameScenesStrategiesEffectsAndKeys) {
  for (const char* what : {"bash", "zsh", "man"}) {
    const ProgramResult result = run_foamsim(std::string("generate ") + what);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    for (const char* name : {"doublebubble", "border-length", "diffusion", "remeshing.longest_edge", "until-rest"}) {
      std::string word = name;  // troff's dashes have a backslash
      if (std::string(what) == "man")
        for (std::size_t at = word.find('-'); at != std::string::npos; at = word.find('-', at + 2))
          word.insert(at, "\\");
      EXPECT_NE(result.out.find(word), std::string::npos) << what << " " << name;
    }
  }
}

TEST(ConvertCommand, KeepsTheSurfaceThroughEveryFormat) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --steps 0 --out " + (scratch / "run")).exit_code, 0);
  std::string last = scratch / "run/frames/frame_000000.ply";
  for (const char* next : {"b.rec", "c.arec", "d.vtp", "e.fe", "f.ply"}) {
    ASSERT_EQ(run_foamsim("convert " + last + " " + (scratch / next)).exit_code, 0) << next;
    last = scratch / next;
  }
  EXPECT_EQ(read_file(scratch / "f.ply"), read_file(scratch / "run/frames/frame_000000.ply"));
  // Film by film and turned: another order, and a sum's last bits.
  ASSERT_EQ(run_foamsim("convert " + last + " " + (scratch / "a.obj")).exit_code, 0);
  const auto before = json::parse(run_foamsim("inspect --json " + last).out);
  const auto after = json::parse(run_foamsim("inspect --json " + (scratch / "a.obj")).out);
  for (const char* same : {"vertices", "triangles", "edges", "junction_edges"}) EXPECT_EQ(after[same], before[same]);
  EXPECT_NEAR(after["area"].get<double>() / before["area"].get<double>(), 1, 1e-12);
}

TEST(RunCommand, TakesASceneByNameBesideAFolderOfThatName) {
  const ScratchFolder scratch;
  const std::string there = "cd " + scratch.path().string() + " &&";
  ASSERT_EQ(run_foamsim("run sphere --set n=1 --steps 1 --quiet --out sphere", there).exit_code, 0);
  EXPECT_EQ(run_foamsim("run sphere --set n=1 --steps 1 --quiet --out another", there).exit_code, 0);
  EXPECT_NE(run_foamsim("run ./sphere", there).error.find("--resume"), std::string::npos);
}

TEST(ConvertCommand, AStarStandsForManyFiles) {
  const ScratchFolder scratch;
  ASSERT_EQ(
      run_foamsim("run sphere --set n=1 --steps 2 --set frame_every=1 --quiet --out " + (scratch / "run")).exit_code,
      0);
  const std::string frames = "'" + (scratch / "run/frames/frame_*.ply") + "' ";
  ASSERT_EQ(run_foamsim("convert " + frames + "'" + (scratch / "new/step*.obj") + "'").exit_code, 0);
  for (const char* name : {"step000000.obj", "step000001.obj", "step000002.obj"})
    EXPECT_EQ(run_foamsim("inspect " + (scratch / "new") + "/" + name).exit_code, 0) << name;
  for (const std::string& bad : {frames + (scratch / "one.obj"), frames + "'" + (scratch / "bad/*.stl") + "'",
                                 "'" + (scratch / "run/none_*.ply") + "' '" + (scratch / "bad/*.obj") + "'",
                                 "'" + (scratch / "*/frames/frame_*.ply") + "' '" + (scratch / "bad/*.obj") + "'"}) {
    const ProgramResult result = run_foamsim("convert " + bad);
    EXPECT_EQ(result.exit_code, 2) << bad;
    EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "bad"));
}

TEST(RunCommand, StartsFromAMeshFileAndAReferenceOptionFile) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --steps 0 --out " + (scratch / "run")).exit_code, 0);
  EXPECT_EQ(run_foamsim("run " + (scratch / "run/frames/frame_000000.ply") + " --steps 2 --out " + (scratch / "mesh"))
                .exit_code,
            0);
  std::ofstream(scratch / "old.txt")
      << "scene doublebubble\ntime-step 0.02 # seconds\nsimulation-time 0.4\nmesh-size-n 24\n"
         "RK4-velocity-integration 1\nsmoothing-coef 5\nlooped 0\n"
         "lostopos-allow-topology-changes 1\nlostopos-t1-transition-enabled 0\n"
         "lostopos-t1-pull-apart-distance-fraction 0.05\nlostopos-merge-proximity-epsilon-fraction 0.02\n";
  const ProgramResult old = run_foamsim("run " + (scratch / "old.txt") + " --out " + (scratch / "old"));
  ASSERT_EQ(old.exit_code, 0) << old.error;
  EXPECT_NE(old.error.find("looped"), std::string::npos) << "what has no meaning here has to be named";
  const json run = json::parse(read_file(scratch / "old/run.json"));
  EXPECT_EQ(run["options"]["dt"], 0.02);
  EXPECT_EQ(run["options"]["n"], 24);
  EXPECT_EQ(run["options"]["integrator"], "rk4");
  EXPECT_EQ(run["options"]["diffusion"], 10.0);
  EXPECT_EQ(run["options"]["topology.enabled"], true);
  EXPECT_EQ(run["options"]["topology.separate"], false);
  EXPECT_EQ(run["options"]["topology.pull_apart"], 0.05);
  EXPECT_EQ(run["options"]["topology.merge_distance"], 0.02);
  EXPECT_EQ(run["last_step"], 10) << "its clock runs twice as fast";
}

TEST(RenderCommand, DrawsEachFrameAtTheAskedSize) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run sphere --set n=2 --steps 1 --set frame_every=1 --out " + (scratch / "run")).exit_code, 0);
  const ProgramResult result = run_foamsim("render " + (scratch / "run/frames/frame_000000.ply") + " " +
                                           (scratch / "run/frames/frame_000001.ply") +
                                           " --size 64x48 --samples 1 --out " + (scratch / "pictures"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const std::string png = read_file(scratch / "pictures/frame_000001.png");
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<int>(png[19]), 64);
  EXPECT_EQ(static_cast<int>(png[23]), 48);
}

}  // namespace
}  // namespace foamsim::test
