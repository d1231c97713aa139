// Surfaces to Surface Evolver and back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* evolver = "/usr/bin/evolver";

// The first frame of a scene as a datafile.
void write_start(const ScratchFolder& scratch, const std::string& scene) {
  ASSERT_EQ(run_foamsim("run " + scene + " --steps 0 --quiet --out " + (scratch / "run")).exit_code, 0);
  ASSERT_EQ(run_foamsim("convert " + (scratch / "run/frames/frame_000000.ply") + " " + (scratch / "a.fe")).exit_code,
            0);
}

// Steps of no length at the end bring volumes back, which those before keep to second order.
void relax(const ScratchFolder& scratch) {
  std::ofstream(scratch.path() / "commands")
      << "quiet on\ng 10\nm 0\ng 5\ndump \"" << (scratch / "b.fe") << "\"\nq\nq\n";
  const std::string command = std::string(evolver) + " " + (scratch / "a.fe") + " <" + (scratch / "commands") + " >" +
                              (scratch / "log") + " 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << read_file(scratch / "log");
  ASSERT_TRUE(fs::exists(scratch.path() / "b.fe")) << read_file(scratch / "log");
}

nlohmann::json inspected_surface(const std::string& file) {
  const ProgramResult result = run_foamsim("inspect --json " + file);
  EXPECT_EQ(result.error, "");
  return nlohmann::json::parse(result.out);
}

TEST(Evolver, RelaxesOurBubblesWithTheirVolumesAndGivesThemBack) {
  if (!fs::exists(evolver)) GTEST_SKIP() << "evolver is not installed (package evolver-nox)";
  const ScratchFolder scratch;
  write_start(scratch, "doublebubble --set n=8");
  relax(scratch);
  const auto before = inspected_surface(scratch / "run/frames/frame_000000.ply"),
             sent = inspected_surface(scratch / "a.fe"), after = inspected_surface(scratch / "b.fe");
  EXPECT_EQ(sent["volumes"], before["volumes"]) << "to the bit";
  ASSERT_EQ(after["volumes"].size(), 3U);
  for (const auto& [region, volume] : before["volumes"].items())
    EXPECT_NEAR(after["volumes"][region].get<double>() / volume.get<double>(), 1, 1e-6) << "region " << region;
  EXPECT_EQ(after["triangles"], before["triangles"]);
  EXPECT_LT(after["area"].get<double>(), 0.999 * before["area"].get<double>());
  ASSERT_EQ(run_foamsim("convert " + (scratch / "b.fe") + " " + (scratch / "c.ply")).exit_code, 0);
  EXPECT_EQ(run_foamsim("run " + (scratch / "c.ply") + " --steps 1 --quiet --out " + (scratch / "next")).exit_code, 0);
}

// The frame that films end at is held there as it is here.
TEST(Evolver, KeepsFilmsInTheirFrame) {
  if (!fs::exists(evolver)) GTEST_SKIP() << "evolver is not installed (package evolver-nox)";
  const ScratchFolder scratch;
  write_start(scratch, "triplejunction-frame");
  relax(scratch);
  const auto before = inspected_surface(scratch / "a.fe"), after = inspected_surface(scratch / "b.fe");
  EXPECT_EQ(after["open_edges"], before["open_edges"]);
  EXPECT_GT(after["area"].get<double>(), 0.5 * before["area"].get<double>());
  EXPECT_EQ(run_foamsim("run " + (scratch / "b.fe") + " --steps 1 --quiet --out " + (scratch / "next")).exit_code, 0);
}

TEST(Evolver, WhatOurSurfacesDoNotHaveIsRefusedInALine) {
  const ScratchFolder scratch;
  write_start(scratch, "sphere --set n=1");
  const std::string surface = read_file(scratch / "a.fe");
  std::ofstream(scratch.path() / "wall.fe") << "constraint 1\nformula: z = 0\n" << surface;
  const ProgramResult wall = run_foamsim("convert " + (scratch / "wall.fe") + " " + (scratch / "wall.ply"));
  EXPECT_EQ(wall.exit_code, 2);
  EXPECT_NE(wall.error.find("wall.fe, line 1: 'constraint' has no place in a surface"), std::string::npos)
      << wall.error;
  EXPECT_EQ(std::count(wall.error.begin(), wall.error.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(scratch.path() / "wall.ply"));
}

TEST(Evolver, FilmsOfDifferentTensionsAreConvertedButNotRun) {
  const ScratchFolder scratch;
  write_start(scratch, "sphere --set n=1");
  std::string surface = read_file(scratch / "a.fe");
  const std::size_t first = surface.find("faces\n1 "), end = surface.find('\n', first + 6);
  std::ofstream(scratch.path() / "two.fe") << surface.insert(end, " tension 2");
  EXPECT_EQ(run_foamsim("convert " + (scratch / "two.fe") + " " + (scratch / "two.vtp")).exit_code, 0);
  EXPECT_EQ(run_foamsim("convert " + (scratch / "two.vtp") + " " + (scratch / "again.fe")).exit_code, 0);
  EXPECT_EQ(read_file(scratch / "again.fe"), surface);
  const ProgramResult run = run_foamsim("run " + (scratch / "two.fe") + " --steps 1 --out " + (scratch / "tensions"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.error.find("films have tensions of 1 to 2; there is one for all here, 'sigma'"), std::string::npos)
      << run.error;
  EXPECT_FALSE(fs::exists(scratch.path() / "tensions"));
}

}  // namespace
}  // namespace foamsim::test
