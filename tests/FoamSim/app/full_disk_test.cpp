// What a disk that is full does to a run: one line, exit code 4, and nothing half written.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

void expect_full(const ProgramResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 4) << result.error;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
}

TEST(FullDisk, BehindStdoutIsAnError) {
  for (const char* command : {"scenes", "effects", "--help", "generate man"})
    expect_full(::test::run_program("sh -c '" FOAMSIM_PROGRAM, std::string(command) + " >/dev/full'"),
                "cannot write the output");
}

// A limit on the size of files stands in for a full disk: writes fail in the same places.
TEST(FullDisk, AtTheStartLeavesNothing) {
  const ScratchFolder scratch;
  expect_full(run_foamsim("run doublebubble --steps 2 --out " + (scratch / "run"), "ulimit -f 4;"), scratch / "run");
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

TEST(FullDisk, LaterKeepsWholeRowsAndFrames) {
  const ScratchFolder scratch;
  // Frames of this sphere are small; the table of metrics outgrows 16 KiB after some dozen steps.
  const ProgramResult result =
      run_foamsim("run mode --set n=1 --steps 2000 --set frame_every=10 --out " + (scratch / "run"), "ulimit -f 16;");
  expect_full(result, "metrics.csv");
  const std::string table = read_file(scratch / "run/metrics.csv");
  ASSERT_FALSE(table.empty());
  EXPECT_EQ(table.back(), '\n');
  const auto columns = [](const std::string& line) { return std::ranges::count(line, ','); };
  EXPECT_EQ(columns(table.substr(table.rfind('\n', table.size() - 2))), columns(table.substr(0, table.find('\n'))));
  for (const auto& frame : fs::directory_iterator(scratch.path() / "run/frames"))
    EXPECT_EQ(run_foamsim("inspect " + frame.path().string()).exit_code, 0) << frame.path();
}

// A disk of its own, which has no room for all frames, and then has.
TEST(FullDisk, LeavesACheckpointThatGoesOnToTheSameBits) {
  const ScratchFolder scratch;
  const std::string disk = scratch / "disk", whole = scratch / "whole", parts = scratch / "parts";
  fs::create_directory(disk);
  const std::string command = " run doublebubble --set n=16 --set frame_every=1 --set checkpoint_every=2 --steps 20";
  std::ofstream(scratch / "script") << "mount -t tmpfs -o size=512k tmpfs " << disk << " || exit 77\n"
                                    << FOAMSIM_PROGRAM << command << " --out " << disk << "/run\necho $? >" << whole
                                    << ".code\nfind " << disk << " -name '*.tmp' >&2\nmount -o remount,size=64m "
                                    << disk << "\n" FOAMSIM_PROGRAM " run --resume " << disk
                                    << "/run --steps 20 --quiet && cp -r " << disk << "/run " << parts << "\n";
  const ProgramResult result = ::test::run_program("unshare", "-m sh " + (scratch / "script"));
  if (!fs::exists(whole + ".code")) GTEST_SKIP() << "no file system can be mounted here: " << result.error;
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(read_file(whole + ".code"), "4\n");
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find("No space left on device; to go on when there is room: --resume " + disk + "/run"),
            std::string::npos)
      << result.error;
  ASSERT_EQ(run_foamsim(command + " --out " + whole).exit_code, 0);
  for (const auto& frame : fs::directory_iterator(whole + "/frames"))
    EXPECT_TRUE(read_file(frame.path()) == read_file(fs::path(parts) / "frames" / frame.path().filename()))
        << frame.path();
  EXPECT_EQ(read_file(parts + "/volumes.csv"), read_file(whole + "/volumes.csv"));
}

}  // namespace
}  // namespace foamsim::test
