// Every option does something, and says so in what a run leaves.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "FoamSim/scenes/scene.h"
#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Change {
  std::string key;
  std::string run;     ///< what is run without the option
  std::string option;  ///< and with it
};

// NOLINTNEXTLINE(readability-function-size): one table
const std::vector<Change>& changes() {
  static const std::string wired_frame =
      "quadjunction-frame --set n=2 --set constraints=wire --set 'wires=free-edges: move 0.5 0 0'";
  static const std::string wired_bubbles =
      "doublebubble --set n=16 --set constraints=wire --set 'wires=x < -1: move -0.5 0 0'";
  static const std::string hung_sheet = "sheet --set reference_units=false";
  static const std::vector<Change> all{
      {"n", "doublebubble", "n=17"},
      {"m", "doublebubble", "m=20"},
      {"mode", "mode", "mode=2"},
      {"amplitude", "mode --set mode=2", "amplitude=0.05"},
      {"gap", "headon --set n=1", "gap=0.3"},
      {"speed", "headon --set n=1", "speed=0.1"},
      {"spheres", "growth", "spheres=3"},
      {"bubbles", "foam", "bubbles=3"},
      {"relaxations", "foam --set bubbles=4 --set relax=0", "relaxations=0"},
      {"relax", "doublebubble", "relax=2"},
      {"layout", "growth", "layout=random"},
      {"displacement", "quadjunction-frame --set n=2", "displacement=0.1"},
      {"dt", "doublebubble", "dt=0.005"},
      {"time", "doublebubble", "time=0.02"},
      {"resolution", "doublebubble", "resolution=0.5"},
      {"delta", "doublebubble", "delta=0.5"},
      {"integrator", "doublebubble", "integrator=rk4"},
      {"constraints", "quadjunction-frame --set n=2", "constraints="},
      {"wires", wired_frame, "'wires=free-edges: move 1 0 0'"},
      {"wire_interior", wired_bubbles, "wire_interior=false"},
      {"wire_weight", wired_bubbles, "wire_weight=0.01"},
      {"open_boundary", wired_frame, "open_boundary=true"},
      {"open_weight", wired_frame + " --set open_boundary=true", "open_weight=0.01"},
      {"rod_radius", hung_sheet, "rod_radius=0.01"},
      {"rod_density", hung_sheet, "rod_density=3000"},
      {"stretching", hung_sheet, "stretching=50"},
      {"bending", hung_sheet, "bending=5"},
      {"rod_damping", hung_sheet, "rod_damping=30"},
      {"gravity", hung_sheet, "gravity=20"},
      {"looped", hung_sheet, "looped=false"},
      {"rod_fixed", hung_sheet, "'rod_fixed=z < 0'"},
      {"air_density", hung_sheet, "air_density=20"},
      {"reference_units", hung_sheet, "reference_units=true"},
      {"rod_open_boundary", hung_sheet, "rod_open_boundary=true"},
      {"remeshing.collapse_to_held", "constrainedsphere --set resolution=0.4", "remeshing.collapse_to_held=true"},
      {"effects", "doublebubble", "effects=surface_tension"},
      {"frame_every", "doublebubble", "frame_every=1"},
      {"metrics_every", "doublebubble", "metrics_every=2"},
      {"checkpoint_every", "doublebubble", "checkpoint_every=1"},
      {"checkpoint_seconds", "doublebubble", "checkpoint_seconds=1e-9"},
      {"rec_every", "doublebubble", "rec_every=1"},
      {"obj_every", "doublebubble", "obj_every=1"},
      {"frame_motion", "doublebubble", "frame_motion=true"},
      {"resolution_mean", "doublebubble", "resolution_mean=triangle-sides"},
      {"vtp", "doublebubble", "vtp=true"},
      {"fields", "doublebubble", "fields=film"},
      {"seed", "doublebubble", "seed=5"},
      {"remeshing.enabled", "doublebubble", "remeshing.enabled=false"},
      {"remeshing.iterations", "doublebubble", "remeshing.iterations=3"},
      {"remeshing.shortest_edge", "doublebubble", "remeshing.shortest_edge=0.7"},
      {"remeshing.longest_edge", "doublebubble", "remeshing.longest_edge=1.2"},
      {"remeshing.min_area", "doublebubble", "remeshing.min_area=0.3"},
      {"remeshing.min_angle", "doublebubble", "remeshing.min_angle=40"},
      {"remeshing.max_angle", "doublebubble", "remeshing.max_angle=80"},
      {"remeshing.split_angle", "doublebubble", "remeshing.split_angle=95"},
      {"remeshing.max_volume_change", "mode --set remeshing.longest_edge=1.05 --set remeshing.butterfly=true",
       "remeshing.max_volume_change=1e-12"},
      {"remeshing.smooth_below", "doublebubble", "remeshing.smooth_below=60"},
      {"remeshing.smoothing", "doublebubble --set n=16", "remeshing.smoothing=false"},
      {"remeshing.butterfly", "mode --set remeshing.longest_edge=1.05", "remeshing.butterfly=true"},
      {"sigma", "doublebubble", "sigma=2"},
      {"velocity", "doublebubble", "velocity=tree"},
      {"tolerance", "doublebubble --set velocity=tree", "tolerance=1e-6"},
      {"order", "doublebubble --set velocity=tree", "order=3"},
      {"area", "doublebubble", "area=naive"},
      {"phi", "doublebubble --set area=constant-edge", "phi=0.9"},
      {"damping", "doublebubble", "effects+=damping --set damping=0.1"},
      {"damping_from", "doublebubble --set effects+=damping --set damping=0.1", "damping_from=0.02"},
      {"diffusion", "doublebubble", "diffusion=1"},
      {"growth", "growth", "growth=1"},
      {"growth_normals", "growth", "growth_normals=unit"},
      {"burst_start", "foam --set burst_start=0.02", "burst_start=0.01"},
      {"burst_interval", "foam --set burst_start=0", "burst_interval=0.02"},
      {"burst_times", "foam", "burst_times=0.02"},
      {"burst_region", "foam --set burst_times=0.02", "burst_region=5"},
      {"blow_rate", "straw", "blow_rate=10"},
      {"blow_region", "carousel", "blow_region=1"},
      {"blow_until", "straw", "blow_until=0.02"},
      {"blow_where", "straw", "'blow_where=held and y > 0'"},
      {"dynamics", "doublebubble", "dynamics=conservative"},
      {"stepping", "doublebubble --set dynamics=conservative", "stepping=rk4"},
      {"viscosity", "doublebubble --set dynamics=conservative", "viscosity=0.3"},
      {"near_field", "doublebubble --set dynamics=conservative", "near_field=false"},
      {"inertia", "doublebubble --set dynamics=conservative", "inertia=false"},
      {"tangential", "doublebubble --set dynamics=conservative", "tangential=none"},
      {"precision", "doublebubble --set dynamics=conservative", "precision=single"},
      {"correction", "doublebubble --set dynamics=conservative", "correction=false"},
      {"most_substeps", "doublebubble --set dynamics=conservative --set dt=0.04", "most_substeps=1"},
      {"safety", "doublebubble --set dynamics=conservative --set dt=0.04", "safety=0.2"},
      {"largest_strain", "doublebubble --set dynamics=conservative --set dt=0.04", "largest_strain=0.001"},
      {"conserving_transfers", "doublebubble --set dynamics=conservative --set n=24 --set time=0.3",
       "conserving_transfers=false"},
      {"forces", "doublebubble --set dynamics=conservative", "forces=pressure-scheme"},
      {"velocities", "doublebubble --set dynamics=conservative", "velocities=sheet"},
  };
  return all;
}

// All that a run leaves, but for its times and the words of its command.
std::string outcome(const std::string& command) {
  const ScratchFolder scratch;
  const std::string time = command.find("time=") == std::string::npos ? " --time 0.04" : "";
  EXPECT_EQ(run_foamsim("run " + command + time + " --out " + (scratch / "run")).exit_code, 0) << command;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path() / "run")) files.push_back(entry.path());
  std::ranges::sort(files);
  std::string text;
  for (const fs::path& file : files) {
    text += file.filename().string();
    if (file.extension() == ".ply") text += read_file(file);
    if (file.filename() == "volumes.csv") text += read_file(file);
    if (file.filename() == "run.json") text += json::parse(read_file(file))["seed"].dump();
  }
  return text;
}

bool seen_elsewhere(const std::string& key) {
  return key.starts_with("tracker.") ||   // where films collide: TrackerOptionsOfScenes
         key.starts_with("topology.") ||  // where films meet: TopologyOptionsOfScenes
         key == "load_dir" ||             // FoamStart, LoadScene
         key == "air_by_stage" ||         // AirByStage
         key == "memory_limit" ||         // what is beyond it: Sizes
         key == "checkpoint_every" ||     // in an interrupted run only: InterruptedRun, KilledRun
         key == "checkpoint_seconds" ||   // the same
         key == "pressure";               // there is one
}

// None is read and then forgotten.
TEST(Options, EachOneHasAnEffect) {
  std::map<std::string, std::string> without;
  for (const base::OptionSpec& spec : all_option_specs(*built_in_catalogue())) {
    if (seen_elsewhere(spec.key)) continue;
    const auto change = std::ranges::find(changes(), spec.key, &Change::key);
    ASSERT_NE(change, changes().end()) << spec.key << " has no case here";
    std::string& base = without[change->run];
    if (base.empty()) base = outcome(change->run);
    EXPECT_TRUE(outcome(change->run + " --set " + change->option) != base) << spec.key;
  }
}

}  // namespace
}  // namespace foamsim::test
