// Two programs and one folder: one works there, the other says who does.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "program.h"

namespace foamsim::test {
namespace {

// Shell words that start a long run in the folder, wait until it is under way, and end it behind `then`.
std::string while_a_run_goes_on(const std::string& folder, const std::string& then) {
  return FOAMSIM_PROGRAM
         " run doublebubble --set n=8 --set frame_every=0 --set checkpoint_every=1 --steps 1000000 "
         "--quiet --out " +
         folder + " & pid=$!; for i in $(seq 300); do [ -e " + folder +
         "/checkpoint.cbor ] && break; sleep 0.1; done\n" + then + "\nkill -TERM $pid; wait $pid; code=$?\n";
}

TEST(RunLock, KeepsEveryOtherCommandOutAndNamesTheProcess) {
  const ScratchFolder scratch;
  const std::string folder = scratch / "run", other = " run doublebubble --set n=8 --steps 2 --out " + folder;
  std::string commands;
  for (const std::string& command : {other, other + " --force", " run --resume " + folder + " --steps 5"})
    commands += FOAMSIM_PROGRAM + command + " 2>>" + (scratch / "said") + "; echo $? >>" + (scratch / "codes") + "\n";
  std::ofstream(scratch / "script") << while_a_run_goes_on(folder, commands + "echo $pid >" + (scratch / "pid"))
                                    << "exit $code\n";
  EXPECT_EQ(::test::run_program("sh", scratch / "script").exit_code, 143);
  EXPECT_EQ(read_file(scratch / "codes"), "2\n2\n2\n");
  std::istringstream said(read_file(scratch / "said")), id(read_file(scratch / "pid"));
  std::string process, line;
  id >> process;
  int lines = 0;
  for (; std::getline(said, line); ++lines)
    EXPECT_NE(line.find("process " + process + " on "), std::string::npos) << line;
  EXPECT_EQ(lines, 3);
  // One that was killed keeps nobody out.
  EXPECT_EQ(run_foamsim("run --resume " + folder + " --steps 0").exit_code, 0);
}

TEST(RunLock, OfAKilledRunIsTakenOverWithoutAWord) {
  const ScratchFolder scratch;
  const std::string folder = scratch / "run";
  std::ofstream(scratch / "script") << while_a_run_goes_on(folder, "kill -KILL $pid");
  ::test::run_program("sh", scratch / "script");
  ASSERT_TRUE(std::filesystem::exists(folder + "/.run.lock"));
  const ProgramResult resumed = run_foamsim("run --resume " + folder + " --steps 0 --quiet");
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_EQ(resumed.error, "");
  EXPECT_FALSE(std::filesystem::exists(folder + "/.run.lock"));
}

TEST(RunLock, LetsOneOfManyThatStartAtOnceRun) {
  const ScratchFolder scratch;
  std::ofstream script(scratch / "script");
  for (int i = 0; i < 6; ++i)
    script << "(" FOAMSIM_PROGRAM " run doublebubble --set n=8 --steps 3 --quiet --out " << (scratch / "run")
           << " 2>/dev/null; echo $? >>" << (scratch / "codes") << ") &\n";
  script << "wait\n";
  script.close();
  ::test::run_program("sh", scratch / "script");
  const std::string codes = read_file(scratch / "codes");
  EXPECT_EQ(std::ranges::count(codes, '0'), 1) << codes;
  EXPECT_EQ(std::ranges::count(codes, '2'), 5) << codes;
  const std::string rows = read_file(scratch / "run/metrics.csv");
  EXPECT_EQ(std::ranges::count(rows, '\n'), 5) << rows;
}

}  // namespace
}  // namespace foamsim::test
