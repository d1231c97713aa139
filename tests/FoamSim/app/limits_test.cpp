// What is too small, too large or too much is refused at the door, in one line, before memory is taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "program.h"
#include "tables.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

void expect_one_line(const ProgramResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 2) << result.error;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
}

std::string tetrahedron(const std::string& size) {
  return "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nv 0 0 " + size + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

TEST(Lengths, OfAMeshHaveToBeComputableWith) {
  const ScratchFolder scratch;
  for (const auto& [size, part] : {std::pair{"1e100", "coordinates have to be between -1e+40 and 1e+40"},
                                   {"1e-100", "lengths of 1e-40 to 1e+40"}}) {
    const std::string file = scratch / "far.obj";
    std::ofstream(file) << tetrahedron(size);
    expect_one_line(run_foamsim("run " + file + " --out " + (scratch / "run")), part);
    expect_one_line(run_foamsim("inspect " + file), part);
    expect_one_line(run_foamsim("convert " + file + " " + (scratch / "far.ply")), part);
    expect_one_line(run_foamsim("render " + file + " --out " + (scratch / "pictures")), part);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1) << "only the mesh";
}

TEST(Lengths, AtTheEdgeOfTheRangeGiveFiniteMeasures) {
  const ScratchFolder scratch;
  for (const char* size : {"1e40", "1e-40"}) {
    std::ofstream(scratch / "mesh.obj") << tetrahedron(size);
    const ProgramResult result = run_foamsim("inspect " + (scratch / "mesh.obj"));
    EXPECT_EQ(result.exit_code, 0) << result.out << result.error;
    for (const char* wrong : {"inf", "nan", "null"})
      EXPECT_EQ(result.out.find(wrong), std::string::npos) << size << ": " << result.out;
  }
}

TEST(Lengths, OfTheResolutionHaveToBeComputableWith) {
  const ScratchFolder scratch;
  expect_one_line(run_foamsim("run sphere --set n=1 --set resolution=1e-60 --out " + (scratch / "run")), "resolution");
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

TEST(Sizes, AreBoundedBeforeMemoryIsTaken) {
  const ScratchFolder scratch;
  const auto refused = [&](const std::string& scene, const std::string& part) {
    // Little memory: what is refused too late ends otherwise.
    expect_one_line(run_foamsim("run " + scene + " --out " + (scratch / "run"), "ulimit -v 4000000;"), part);
  };
  refused("growth --set spheres=1000001", "1 to 1000000");
  refused("growth --set spheres=1000000", "triangles, which take 640 GB");
  refused("doublebubble --set n=1024", "8 to 512");
  refused("barrel --set n=4096 --set m=4096", "memory_limit");
  refused("mode --set mode=1000000000", "0 to 100");
  refused("foam --set bubbles=10 --set relaxations=1000000000", "0 to 1000");
  refused("sphere --set remeshing.iterations=10000000000", "1 to 1000");
  refused("sphere --set n=4 --set memory_limit=0.01", "more than the limit of 10 MB");
  refused("sphere --set n=2 --set resolution=1e-4", "triangles, which take");
  refused("doublebubble --set resolution=1e-4 --set memory_limit=2", "more than the limit of 2 GB");
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

// As a bubble of a mesh file is numbered by whoever made it.
TEST(Sizes, OfRegionNumbersTakeNoMemory) {
  const ScratchFolder scratch;
  const auto bubble = [&](const std::string& region) {
    std::ofstream(scratch / "bubble.ply")
        << "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
           "element face 4\nproperty list uchar int vertex_indices\nproperty int region_a\nproperty int region_b\n"
           "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        << "3 0 2 1 " << region << " 0\n3 0 1 3 " << region << " 0\n3 1 2 3 " << region << " 0\n3 2 0 3 " << region
        << " 0\n";
    return scratch / "bubble.ply";
  };
  const auto metrics = [&](const std::string& region, const std::string& option) {
    const std::string out = scratch / ("run-" + region + "-" + option);
    const ProgramResult result =
        run_foamsim("run " + bubble(region) + " --steps 2 --set resolution=0.3 --set " + option + " --out " + out,
                    "ulimit -v 4000000;");
    EXPECT_EQ(result.exit_code, 0) << option << ", region " << region << ": " << result.error;
    return without_seconds(::test::read_file(out + "/metrics.csv"));
  };
  for (const char* option :
       {"dynamics=vortex-sheet", "dynamics=conservative", "dynamics=relaxation", "effects+=volumes"})
    EXPECT_EQ(metrics("1", option), metrics("2147483647", option)) << option;
}

TEST(Sizes, OfTextFilesAreBoundedBeforeTheyAreRead) {
  const ScratchFolder scratch;
  // Without content on the disk.
  const auto file_of = [&](const char* name, std::uintmax_t bytes) {
    std::ofstream(scratch / name) << "scene";
    fs::resize_file(scratch.path() / name, bytes);
    return scratch / name;
  };
  const std::string out = " --out " + (scratch / "run");
  expect_one_line(run_foamsim("run " + file_of("scene.toml", 1'000'000'000) + out), "it has 1 GB; no scene file");
  expect_one_line(run_foamsim("run " + file_of("options.txt", 1'000'000'000) + out), "it has 1 GB; no option file");
  expect_one_line(run_foamsim("run " + file_of("mesh.obj", 1'000'000'000'000) + out), "has 1 TB, and reading it");
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

TEST(Sizes, OfMessagesAreBoundedToo) {
  const ScratchFolder scratch;
  // NOLINTNEXTLINE(bugprone-string-constructor): it is meant to be long.
  std::ofstream(scratch / "scene.toml") << "scene = \"sphere\"\n" << std::string(10'000'000, 'a') << " = 1\n";
  const ProgramResult result = run_foamsim("run " + (scratch / "scene.toml") + " --out " + (scratch / "run"));
  expect_one_line(result, "scene.toml:2: unknown option 'aaa");
  EXPECT_LT(result.error.size(), 5000U);
}

// What a run comes to on its way: its last whole step stays.
TEST(Sizes, OfARunThatGrowsAreBoundedWithTheFigure) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_foamsim("run sphere --set n=2 --set resolution=0.01 --set memory_limit=0.05 --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 2) << "refused at the door: " << result.error;
  const ProgramResult grown = run_foamsim(
      "run foaminit --set growth=2 --set memory_limit=0.022 --steps 100 --quiet --out " + (scratch / "grown"));
  EXPECT_EQ(grown.exit_code, 3) << grown.error;
  EXPECT_NE(grown.error.find("as many as memory_limit has room for"), std::string::npos) << grown.error;
  EXPECT_TRUE(fs::exists(scratch.path() / "grown/checkpoint.cbor"));
}

}  // namespace
}  // namespace foamsim::test
