// Runs in which films meet, part and vanish: the options that say how, events.csv, and resumed runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "FoamSim/scenes/scene.h"
#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Row> rows_of(const std::string& file) {
  std::istringstream in(read_file(file));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), header.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), header.size()); ++i) row[header[i]] = cells[i];
  }
  return rows;
}

// Everything but wall times.
std::string repeatable(const std::string& metrics_file) {
  std::string text;
  for (const Row& row : rows_of(metrics_file))
    for (const auto& [column, cell] : row)
      if (!column.ends_with("_seconds")) text.append(column).append("=").append(cell).append("\n");
  return text;
}

constexpr int sphere_count = 5;
const std::string growing =
    "growth --set layout=random --set growth=2 --set frame_every=0 --set spheres=" + std::to_string(sphere_count);

void run(const std::string& scene, const std::string& folder) {
  const ProgramResult result = run_foamsim("run " + scene + " --quiet --out " + folder);
  ASSERT_EQ(result.exit_code, 0) << result.error;
}

TEST(AirByStage, FillsItsColumnsWhenItIsAskedFor) {
  const ScratchFolder scratch;
  run("doublebubble --set n=12 --steps 12", scratch / "silent");
  run("doublebubble --set n=12 --steps 12 --set air_by_stage=true", scratch / "asked");
  const std::vector<Row> silent = rows_of(scratch / "silent/metrics.csv");
  const std::vector<Row> asked = rows_of(scratch / "asked/metrics.csv");
  ASSERT_EQ(asked.size(), 13U);
  for (const char* column : {"topology_air_energy", "remesh_air_energy"}) {
    EXPECT_EQ(silent.back().at(column), "") << column;
    EXPECT_TRUE(std::isfinite(std::stod(asked.back().at(column)))) << column;
  }
  EXPECT_TRUE(std::ranges::any_of(asked, [](const Row& row) {
    const std::string& cell = row.at("remesh_air_energy");
    return !cell.empty() && std::stod(cell) != 0;
  }));
}

TEST(EventsTable, HasARowForEveryChangeThatTheMetricsCount) {
  const ScratchFolder scratch;
  run(growing + " --steps 14", scratch / "run");
  EXPECT_TRUE(read_file(scratch / "run/events.csv").starts_with("step,time,kind,regions,x,y,z\n"));
  std::map<std::string, long> count;
  long last_step = 0;
  for (const Row& event : rows_of(scratch / "run/events.csv")) {
    ++count[event.at("kind")];
    const long step = std::stol(event.at("step"));
    EXPECT_LE(last_step, step);
    last_step = step;
    EXPECT_NEAR(std::stod(event.at("time")), 0.01 * static_cast<double>(step), 1e-12);
    std::istringstream regions(event.at("regions"));
    int among = 0;
    for (int region = 0; regions >> region; ++among) EXPECT_TRUE(region >= 0 && region <= sphere_count);
    EXPECT_GE(among, 2) << event.at("regions");
    for (const char* axis : {"x", "y", "z"}) EXPECT_LT(std::abs(std::stod(event.at(axis))), 5);
  }
  const Row end = rows_of(scratch / "run/metrics.csv").back();
  EXPECT_GT(count["snap"], 20);
  EXPECT_GT(count["separation"], 5);
  EXPECT_EQ(std::stol(end.at("snap_count")), count["snap"]);
  EXPECT_EQ(std::stol(end.at("t1_count")), count["separation"]);
  EXPECT_EQ(std::stol(end.at("edge_merges")), count["edge_merge"]);
  EXPECT_EQ(std::stol(end.at("region_collapses")), count["region_collapse"]);
  EXPECT_GT(std::stol(end.at("cancelled_triangles")), 0);
  const json summary = json::parse(read_file(scratch / "run/run.json"))["topology"];
  EXPECT_EQ(summary["snap"]["done"], count["snap"]);
  EXPECT_EQ(summary["separation"]["done"], count["separation"]);
}

TEST(EventsTable, IsNotMadeWhereTheTopologyStays) {
  const ScratchFolder scratch;
  run("doublebubble --steps 1", scratch / "run");
  EXPECT_FALSE(fs::exists(scratch.path() / "run/events.csv"));
}

TEST(EventsTable, ExplainPrintsOperationsAndRefusals) {
  const ScratchFolder scratch;
  const std::string out = run_foamsim("run " + growing + " --steps 8 --explain --quiet --out " + (scratch / "run")).out;
  for (const char* word : {"snap ", "edge_merge ", "separation ", "region_collapse ", "cancelled", "refused:"})
    EXPECT_NE(out.find(word), std::string::npos) << word;
}

// `early` steps, then on to `late`, twice from the same point: what was written behind it before is written anew.
void expect_same_bits_when_resumed(const std::string& scene, long early, long late) {
  const ScratchFolder scratch;
  const std::string last = " --steps " + std::to_string(late);
  run(scene + last, scratch / "whole");
  run(scene + " --steps " + std::to_string(early), scratch / "parts");
  fs::copy_file(scratch / "parts/checkpoint.cbor", scratch / "parts/early.cbor");
  for (const char* checkpoint : {"checkpoint.cbor", "early.cbor"}) {
    const ProgramResult result = run_foamsim("run --resume " + (scratch / "parts/") + checkpoint + last);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const std::string digits = std::to_string(late);
    const std::string frame = "frames/frame_" + std::string(6 - digits.size(), '0') + digits + ".ply";
    EXPECT_EQ(read_file(scratch / ("parts/" + frame)), read_file(scratch / ("whole/" + frame)));
    EXPECT_EQ(read_file(scratch / "parts/events.csv"), read_file(scratch / "whole/events.csv"));
    EXPECT_EQ(repeatable(scratch / "parts/metrics.csv"), repeatable(scratch / "whole/metrics.csv"));
  }
  std::map<bool, int> events;  // before and after the break
  for (const Row& event : rows_of(scratch / "whole/events.csv")) ++events[std::stol(event.at("step")) > early];
  EXPECT_GT(events[false], 3);
  EXPECT_GT(events[true], 3);
}

TEST(InterruptedRun, WithTopologyCanBeResumedToTheSameBits) {
  expect_same_bits_when_resumed(growing, 9, 13);
  expect_same_bits_when_resumed("headon --set n=2 --set gap=0.04", 85, 110);
}

TEST(InterruptedRun, KeepsTheFrameThatHoldsItsFilms) {
  const ScratchFolder scratch;
  run("quadjunction-frame --set n=2 --steps 20", scratch / "whole");
  run("quadjunction-frame --set n=2 --steps 8", scratch / "parts");
  ASSERT_EQ(run_foamsim("run --resume " + (scratch / "parts/checkpoint.cbor") + " --steps 20").exit_code, 0);
  EXPECT_EQ(read_file(scratch / "parts/frames/frame_000020.ply"), read_file(scratch / "whole/frames/frame_000020.ply"));
}

TEST(TopologyOptionsOfScenes, ManyThreadsGiveTheBitsOfOne) {
  const ScratchFolder scratch;
  run(growing + " --steps 14 --threads 1", scratch / "one");
  run(growing + " --steps 14 --threads 2", scratch / "two");
  EXPECT_EQ(read_file(scratch / "one/frames/frame_000014.ply"), read_file(scratch / "two/frames/frame_000014.ply"));
  EXPECT_EQ(read_file(scratch / "one/events.csv"), read_file(scratch / "two/events.csv"));
}

// Where nothing meets, looking for what meets changes nothing.
TEST(TopologyOptionsOfScenes, LeaveAQuietSurfaceAlone) {
  const ScratchFolder scratch;
  run("doublebubble --steps 60 --set topology.enabled=true", scratch / "on");
  run("doublebubble --steps 60", scratch / "off");
  EXPECT_EQ(read_file(scratch / "on/frames/frame_000060.ply"), read_file(scratch / "off/frames/frame_000060.ply"));
  EXPECT_EQ(read_file(scratch / "on/events.csv"), "step,time,kind,regions,x,y,z\n");
}

// What a run leaves: its last surface, and how often each thing happened.
struct Outcome {
  std::string frame;
  Row end;
  long count(const char* column) const { return std::stol(end.at(column)); }
};

Outcome outcome_of(const std::string& assignment) {
  const ScratchFolder scratch;
  run(growing + " --steps 14" + (assignment.empty() ? "" : " --set " + assignment), scratch / "run");
  return {read_file(scratch / "run/frames/frame_000014.ply"), rows_of(scratch / "run/metrics.csv").back()};
}

TEST(TopologyOptionsOfScenes, EachOneHasItsEffect) {
  const Outcome base = outcome_of("");
  const std::map<std::string, std::string> changed{
      {"topology.enabled", "false"},      {"topology.snap", "false"},         {"topology.separate", "false"},
      {"topology.merge_distance", "0.2"}, {"topology.pull_apart", "0.05"},    {"topology.longest_motion", "0.05"},
      {"topology.merge_edge", "0.09"},    {"topology.max_sweeps", "1"},       {"topology.smallest_region", "12"},
      {"topology.separation", "flow"},    {"topology.collapse_regions", "-"},  // below
  };
  std::map<std::string, Outcome> outcomes;
  for (const base::OptionSpec& spec : common_option_specs(*built_in_catalogue())) {
    if (!spec.key.starts_with("topology.")) continue;
    ASSERT_TRUE(changed.contains(spec.key)) << spec.key << " has no case here";
    if (changed.at(spec.key) == "-") continue;
    outcomes[spec.key] = outcome_of(spec.key + "=" + changed.at(spec.key));
    EXPECT_NE(outcomes[spec.key].frame, base.frame) << spec.key;
  }
  EXPECT_EQ(outcomes["topology.enabled"].count("snap_count"), 0);
  EXPECT_EQ(outcomes["topology.snap"].count("snap_count"), 0);
  EXPECT_EQ(outcomes["topology.separate"].count("t1_count"), 0);
  EXPECT_GT(outcomes["topology.separate"].count("incomplete_vertices"), 0);
  EXPECT_EQ(base.count("regions"), 6);
  const Outcome& collapsed = outcomes["topology.smallest_region"];
  EXPECT_GT(collapsed.count("region_collapses"), 0);
  // Parts of regions (pockets of air, say) count, too.
  EXPECT_LT(collapsed.count("regions"), 6);
  EXPECT_GE(collapsed.count("region_collapses"), 6 - collapsed.count("regions"));
  const Outcome kept = outcome_of("topology.smallest_region=12 --set topology.collapse_regions=false");
  EXPECT_EQ(kept.count("regions"), 6);
}

// A separation has to open more than what is merged.
TEST(TopologyOptionsOfScenes, MergeEdgeLeavesRoomToPart) {
  const ScratchFolder scratch;
  const ProgramResult refused =
      run_foamsim("run doublebubble --set topology.merge_edge=0.1 --steps 1 --out " + (scratch / "run"));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.error.find("topology.merge_edge = 0.1"), std::string::npos) << refused.error;
  EXPECT_FALSE(fs::exists(scratch / "run"));
  // Conservative dynamics bring both along, the one in proportion to the other.
  const std::string conservative = "doublebubble --set n=8 --set dynamics=conservative --steps 1";
  const auto merge_edge = [&](const std::string& more) {
    const ScratchFolder own;
    run(conservative + more, own / "run");
    return nlohmann::json::parse(read_file(own / "run/run.json"))["options"]["topology.merge_edge"].get<double>();
  };
  EXPECT_EQ(merge_edge(""), 0.1);
  EXPECT_EQ(merge_edge(" --set topology.pull_apart=0.1"), 0.05);
  EXPECT_EQ(merge_edge(" --set topology.pull_apart=0.4"), 0.1);
}

}  // namespace
}  // namespace foamsim::test
