#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "program.h"

namespace foamsim::test {
namespace {

using nlohmann::json;

// Two bubbles of different regions, 0.005 apart.
void write_near_bubbles(const ScratchFolder& scratch) {
  ASSERT_EQ(run_foamsim("run mode --set n=2 --set mode=2 --set amplitude=-0.15 --steps 0 --out " + (scratch / "one"))
                .exit_code,
            0);
  ASSERT_EQ(run_foamsim("convert " + (scratch / "one/frames/frame_000000.ply") + " " + (scratch / "one.obj")).exit_code,
            0);
  std::ifstream in(scratch / "one.obj");
  std::ofstream out(scratch / "two.obj");
  std::string vertices, faces;
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    double x = 0, y = 0, z = 0;
    int a = 0, b = 0, c = 0;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) {
      ++count;
      vertices += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    } else if (std::sscanf(line.c_str(), "f %d %d %d", &a, &b, &c) == 3) {
      faces += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
  }
  ASSERT_GT(count, 0);
  out << vertices;
  std::istringstream again(vertices);
  for (std::string line; std::getline(again, line);) {
    double x = 0, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z), 3);
    out << "v " << x + 1.705 << " " << y << " " << z << "\n";
  }
  out << "g region_1_0\n" << faces << "g region_2_0\n";
  std::istringstream second(faces);
  for (std::string line; std::getline(second, line);) {
    int a = 0, b = 0, c = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "f %d %d %d", &a, &b, &c), 3);
    out << "f " << a + count << " " << b + count << " " << c + count << "\n";
  }
}

std::string last_audit(const ScratchFolder& scratch, const std::string& run) {
  const json j = json::parse(read_file(scratch.path() / run / "run.json"));
  const std::string frame = (scratch.path() / run / "frames" / j["last_frame"].get<std::string>()).string();
  return json::parse(run_foamsim("inspect --json " + frame).out)["audit"];
}

json run_of(const ScratchFolder& scratch, const std::string& name, const std::string& command) {
  EXPECT_EQ(run_foamsim("run " + command + " --set frame_every=0 --out " + (scratch / name), "timeout 60").exit_code,
            0);
  return json::parse(read_file(scratch.path() / name / "run.json"));
}

TEST(TrackerOptionsOfScenes, ProximityPushesNearBubblesApart) {
  const ScratchFolder scratch;
  write_near_bubbles(scratch);
  const std::string apart = (scratch / "two.obj") + " --steps 3 --set topology.enabled=false";
  const json quiet = run_of(scratch, "quiet", apart);
  const json wide = run_of(scratch, "wide", apart + " --set tracker.proximity=0.05");
  EXPECT_EQ(quiet["collisions"]["proximities"].get<long>(), 0);
  EXPECT_GT(wide["collisions"]["proximities"].get<long>(), 0);
  EXPECT_GT(wide["collisions"]["impulses"].get<long>(), 0);
  EXPECT_EQ(last_audit(scratch, "wide"), "clean");
}

// With so long a step the films would run through each other.
TEST(TrackerOptionsOfScenes, CollisionsKeepTheFilmsApart) {
  const ScratchFolder scratch;
  const std::string rough = "doublebubble --set dt=0.2 --set remeshing.enabled=false --steps 16";
  const json apart = run_of(scratch, "apart", rough);
  const json through = run_of(scratch, "through", rough + " --set tracker.collisions=false");
  EXPECT_GT(apart["collisions"]["collisions"].get<long>(), 0);
  EXPECT_EQ(through["collisions"]["collisions"].get<long>(), 0);
  EXPECT_EQ(last_audit(scratch, "apart"), "clean");
  EXPECT_EQ(last_audit(scratch, "through"), "not clean");
}

}  // namespace
}  // namespace foamsim::test
