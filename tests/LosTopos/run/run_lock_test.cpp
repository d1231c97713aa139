// One run at a time works in a folder.
#include "LosTopos/run/run_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/LosTopos/run/fake_motion.h"
#include "tests/support/run_program.h"
#include "tests/support/scratch_folder.h"

namespace lostopos::run {
namespace {

namespace fs = std::filesystem;
using test::FakeMotion;
using ::test::read_file;
using ::test::ScratchFolder;

Output plain_output_in(const fs::path& folder) {
  Output output;
  output.folder = folder;
  output.checkpoint = {"fake", 1};
  return output;
}

std::string refusal_of(const Output& output) {
  FakeMotion motion(output.go_on ? 3 : 0);
  try {
    run_motion(motion, {.last_step = 5}, output);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RunLock, KeepsOthersOutWhileARunGoesOnAndNamesIt) {
  const ScratchFolder scratch;
  const Output output = plain_output_in(scratch.path() / "run");
  std::vector<std::string> refusals;
  Hooks hooks;
  hooks.stepped = [&](double) {
    Output other = output;
    refusals.push_back(refusal_of(other));
    other.force = true;
    refusals.push_back(refusal_of(other));
    other.force = false;
    other.go_on = true;
    refusals.push_back(refusal_of(other));
  };
  FakeMotion motion;
  run_motion(motion, {.last_step = 2}, output, hooks);
  ASSERT_EQ(refusals.size(), 6U);
  for (const std::string& refusal : refusals) {
    EXPECT_NE(refusal.find("process " + std::to_string(::getpid()) + " on "), std::string::npos) << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
  EXPECT_EQ(read_file(scratch / "run/metrics.csv"), "step,time\n0,0.000000\n2,1.000000\n");
}

TEST(RunLock, EndsWithTheRun) {
  const ScratchFolder scratch;
  const Output output = plain_output_in(scratch.path() / "run");
  FakeMotion motion;
  run_motion(motion, {.last_step = 3}, output);
  EXPECT_FALSE(fs::exists(scratch / "run/.run.lock"));
  EXPECT_NE(refusal_of(output).find("already holds a run"), std::string::npos);
  EXPECT_FALSE(fs::exists(scratch / "run/.run.lock"));
}

TEST(RunLock, OfAKilledProcessLocksNobodyOut) {
  const ScratchFolder scratch;
  const Output output = plain_output_in(scratch.path() / "run");
  const pid_t child = ::fork();
  if (child == 0) {
    fs::create_directory(output.folder);
    const RunLock lock(output.folder);
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(scratch / "run/.run.lock"));
  EXPECT_EQ(refusal_of(output), "");
  EXPECT_FALSE(fs::exists(scratch / "run/.run.lock"));
}

}  // namespace
}  // namespace lostopos::run
