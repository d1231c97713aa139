#include "Base/process/child_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "Base/error.h"
#include "Base/io/file_lock.h"
#include "tests/support/scratch_folder.h"

namespace base {
namespace {

using ::test::ScratchFolder;

// Waits at most some seconds.
std::optional<ProcessEnd> end_within_seconds(ChildProcess& process) {
  for (int i = 0; i < 2000; ++i) {
    if (const auto end = process.end()) return end;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return std::nullopt;
}

ProcessStart shell(const std::string& command, const ScratchFolder& scratch) {
  return {.program = "sh", .arguments = {"-c", command}, .output = scratch / "output"};
}

TEST(ChildProcess, SaysHowItEndedAndWhatItPrinted) {
  const ScratchFolder scratch;
  ChildProcess process(shell("echo one; echo two >&2; exit 7", scratch));
  const auto end = end_within_seconds(process);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->exit_code, 7);
  EXPECT_EQ(end->signal, 0);
  std::ostringstream text;
  text << std::ifstream(scratch / "output").rdbuf();
  EXPECT_EQ(text.str(), "one\ntwo\n");
}

TEST(ChildProcess, SaysWhichSignalEndedIt) {
  const ScratchFolder scratch;
  ChildProcess process(shell("kill -SEGV $$", scratch));
  const auto end = end_within_seconds(process);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->signal, SIGSEGV);
  EXPECT_EQ(end->exit_code, 128 + SIGSEGV);
  EXPECT_EQ(signal_text(SIGSEGV), "ended by signal 11 (Segmentation fault)");
}

TEST(ChildProcess, IsAskedToEndWhenItIsNoLongerHeld) {
  const ScratchFolder scratch;
  const auto begin = std::chrono::steady_clock::now();
  { const ChildProcess process(shell("exec sleep 60", scratch)); }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(ChildProcess, OfNoProgramIsAnError) {
  const ScratchFolder scratch;
  EXPECT_THROW(ChildProcess({.program = scratch / "nothing", .arguments = {}, .output = scratch / "output"}),
               FileError);
}

TEST(FileLock, IsHeldByAProcessThatInheritedItAndByNobodyAfterIt) {
  const ScratchFolder scratch;
  std::optional<FileLock> lock = FileLock::take(scratch / "lock");
  ASSERT_TRUE(lock);
  EXPECT_FALSE(FileLock::take(scratch / "lock"));
  ProcessStart start = shell("exec sleep 60", scratch);
  start.keep_open = lock->descriptor();
  ChildProcess holder(start);
  ChildProcess other(shell("exec sleep 60", scratch));  // it inherits nothing
  lock.reset();
  EXPECT_FALSE(FileLock::take(scratch / "lock"));
  holder.signal(SIGKILL);
  ASSERT_TRUE(end_within_seconds(holder));
  EXPECT_TRUE(FileLock::take(scratch / "lock"));
}

TEST(RunCommand, ReturnsCodeAndOutputAndDoesNotWaitForever) {
  const CommandResult result = run_command("sh", {"-c", "echo hello; exit 3"}, 20);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "hello\n");
  EXPECT_THROW(run_command("sleep", {"60"}, 0.1), Error);
  EXPECT_THROW(run_command("no-such-program-anywhere", {}, 1), FileError);
}

}  // namespace
}  // namespace base
