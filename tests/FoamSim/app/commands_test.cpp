#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
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

TEST(RunCommand, QuietPrintsNothing) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim("run sphere --set n=1 --steps 3 --quiet --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.error, "");
}

TEST(RunCommand, EveryBuiltInSceneRuns) {
  for (const SceneEntry& scene : built_in_scenes()) {
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

// Those of every scene, and each scene's own.
std::vector<base::OptionSpec> all_options() {
  std::vector<base::OptionSpec> specs = common_option_specs(*built_in_catalogue());
  for (const SceneEntry& scene : built_in_scenes())
    specs.insert(specs.end(), scene.options.begin(), scene.options.end());
  return specs;
}

// Every option has to change what a run writes: none is read and then forgotten.
TEST(Options, EachOneHasAnEffect) {
  const std::vector<std::pair<std::string, std::string>> changes{
      {"n", "run doublebubble --set n=17"},
      {"mode", "run sphere --set mode=2"},
      {"amplitude", "run sphere --set mode=2 --set amplitude=0.05"},
      {"gap", "run twobubbles --set n=1 --set gap=0.3"},
      {"speed", "run twobubbles --set n=1 --set speed=0.1"},
      {"spheres", "run foaminit --set spheres=3"},
      {"layout", "run foaminit --set layout=random"},
      {"displacement", "run quadjunction --set n=2 --set displacement=0.1"},
      {"dt", "run doublebubble --set dt=0.005"},
      {"time", "run doublebubble --set time=0.02"},
      {"resolution", "run doublebubble --set resolution=0.5"},
      {"delta", "run doublebubble --set delta=0.5"},
      {"integrator", "run doublebubble --set integrator=rk4"},
      {"constraints", "run quadjunction --set n=2 --set constraints="},
      {"effects", "run doublebubble --set effects=surface_tension"},
      {"frame_every", "run doublebubble --set frame_every=1"},
      {"metrics_every", "run doublebubble --set metrics_every=2"},
      {"checkpoint_every", "run doublebubble --set checkpoint_every=1"},
      {"vtp", "run doublebubble --set vtp=true"},
      {"seed", "run doublebubble --set seed=5"},
      {"remeshing.enabled", "run doublebubble --set remeshing.enabled=false"},
      {"remeshing.iterations", "run doublebubble --set remeshing.iterations=3"},
      {"remeshing.shortest_edge", "run doublebubble --set remeshing.shortest_edge=0.7"},
      {"remeshing.longest_edge", "run doublebubble --set remeshing.longest_edge=1.2"},
      {"remeshing.min_area", "run doublebubble --set remeshing.min_area=0.3"},
      {"remeshing.min_angle", "run doublebubble --set remeshing.min_angle=40"},
      {"remeshing.max_angle", "run doublebubble --set remeshing.max_angle=80"},
      {"remeshing.split_angle", "run doublebubble --set remeshing.split_angle=95"},
      {"remeshing.max_volume_change",
       "run sphere --set remeshing.longest_edge=1.05 --set remeshing.butterfly=true --set "
       "remeshing.max_volume_change=1e-12"},
      {"remeshing.smooth_below", "run doublebubble --set remeshing.smooth_below=60"},
      {"remeshing.smoothing", "run doublebubble --set n=16 --set remeshing.smoothing=false"},
      {"remeshing.butterfly", "run sphere --set remeshing.longest_edge=1.05 --set remeshing.butterfly=true"},
      {"sigma", "run doublebubble --set sigma=2"},
      {"area", "run doublebubble --set area=naive"},
      {"phi", "run doublebubble --set area=constant-edge --set phi=0.9"},
      {"damping", "run doublebubble --set effects+=damping --set damping=0.1"},
      {"damping_from", "run doublebubble --set effects+=damping --set damping=0.1 --set damping_from=0.02"},
      {"diffusion", "run doublebubble --set diffusion=1"},
      {"growth", "run foaminit --set growth=1"},
      {"dynamics", "run doublebubble --set dynamics=conservative"},
      {"stepping", "run doublebubble --set dynamics=conservative --set stepping=rk4"},
      {"viscosity", "run doublebubble --set dynamics=conservative --set viscosity=0.3"},
      {"near_field", "run doublebubble --set dynamics=conservative --set near_field=false"},
      {"inertia", "run doublebubble --set dynamics=conservative --set inertia=false"},
      {"tangential", "run doublebubble --set dynamics=conservative --set tangential=none"},
      {"correction", "run doublebubble --set dynamics=conservative --set correction=false"},
      {"most_substeps", "run doublebubble --set dynamics=conservative --set dt=0.04 --set most_substeps=1"},
      {"safety", "run doublebubble --set dynamics=conservative --set dt=0.04 --set safety=0.2"},
      {"largest_strain", "run doublebubble --set dynamics=conservative --set dt=0.04 --set largest_strain=0.001"},
      {"conserving_transfers",
       "run doublebubble --set dynamics=conservative --set n=24 --set time=0.3 --set conserving_transfers=false"},
  };
  auto outcome = [](const std::string& command) {
    const ScratchFolder scratch;
    EXPECT_EQ(run_foamsim(command + (command.find("time=") == std::string::npos ? " --time 0.04" : "") + " --out " +
                          (scratch / "run"))
                  .exit_code,
              0)
        << command;
    // All that a run leaves, but for its times and the words of its command.
    std::string text;
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(scratch.path() / "run")) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) {
      text += file.filename().string();
      if (file.extension() == ".ply") text += read_file(file);
      if (file.filename() == "volumes.csv") text += read_file(file);
      if (file.filename() == "run.json") text += json::parse(read_file(file))["seed"].dump();
    }
    return text;
  };
  const std::string double_bubble = outcome("run doublebubble"), sphere = outcome("run sphere");
  const std::string curved = outcome("run sphere --set remeshing.longest_edge=1.05 --set remeshing.butterfly=true");
  const std::string finer = outcome("run sphere --set remeshing.longest_edge=1.05");
  const std::string mode = outcome("run sphere --set mode=2"),
                    constant_edge = outcome("run doublebubble --set area=constant-edge");
  const std::string two_bubbles = outcome("run twobubbles --set n=1"), foam = outcome("run foaminit"),
                    junction = outcome("run quadjunction --set n=2");
  const std::string damped = outcome("run doublebubble --set effects+=damping --set damping=0.1");
  const std::string conservative = outcome("run doublebubble --set dynamics=conservative"),
                    long_steps = outcome("run doublebubble --set dynamics=conservative --set dt=0.04"),
                    remeshed = outcome("run doublebubble --set dynamics=conservative --set n=24 --set time=0.3");
  const std::set<std::string> of_conservative{"stepping", "viscosity",  "near_field",
                                              "inertia",  "tangential", "correction"};
  const std::set<std::string> of_long_steps{"most_substeps", "safety", "largest_strain"};
  for (const base::OptionSpec& spec : all_options()) {
    const auto it = std::ranges::find(changes, spec.key, &std::pair<std::string, std::string>::first);
    if (spec.key.starts_with("tracker.")) continue;                  // seen where films collide: TrackerOptionsOfScenes
    if (spec.key.starts_with("topology.")) continue;                 // seen where films meet: TopologyOptionsOfScenes
    if (spec.key == "pressure" || spec.key == "velocity") continue;  // there is one of each
    ASSERT_NE(it, changes.end()) << spec.key << " has no case here";
    if (spec.key == "checkpoint_every") continue;  // seen by an interrupted run only: InterruptedRun.CanBeResumed
    const std::string& base = of_conservative.contains(spec.key)                                      ? conservative
                              : of_long_steps.contains(spec.key)                                      ? long_steps
                              : spec.key == "conserving_transfers"                                    ? remeshed
                              : spec.key == "mode"                                                    ? sphere
                              : spec.key == "amplitude"                                               ? mode
                              : spec.key == "phi"                                                     ? constant_edge
                              : spec.key == "damping_from"                                            ? damped
                              : spec.key == "gap" || spec.key == "speed"                              ? two_bubbles
                              : spec.key == "spheres" || spec.key == "layout" || spec.key == "growth" ? foam
                              : spec.key == "displacement" || spec.key == "constraints"               ? junction
                              : spec.key == "remeshing.butterfly"                                     ? finer
                              : spec.key == "remeshing.max_volume_change"                             ? curved
                                                                                                      : double_bubble;
    EXPECT_TRUE(outcome(it->second) != base) << spec.key;
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
  for (const base::OptionSpec& spec : all_options())
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
  for (const char* next : {"a.obj", "b.rec", "c.arec", "d.vtp", "e.ply"}) {
    ASSERT_EQ(run_foamsim("convert " + last + " " + (scratch / next)).exit_code, 0) << next;
    last = scratch / next;
  }
  EXPECT_EQ(read_file(scratch / "e.ply"), read_file(scratch / "run/frames/frame_000000.ply"));
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
  EXPECT_EQ(run["options"]["diffusion"], 5.0);
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
