#include "Base/io/temporary_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>

#include "Base/io/atomic_file.h"
#include "tests/support/scratch_folder.h"

namespace base {
namespace {

namespace fs = std::filesystem;
using ::test::ScratchFolder;

// The number of a process that has ended.
pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(TemporaryFiles, OfEndedProcessesAreRemovedAndNothingElse) {
  const ScratchFolder scratch;
  const std::string dead = std::to_string(dead_process()), alive = std::to_string(::getppid());
  const std::set<std::string> stays{".a.csv." + alive + "-0.tmp",
                                    "a.csv",
                                    ".a.csv." + dead + "-0",
                                    "a.csv." + dead + "-0.tmp",
                                    ".tmp",
                                    ".a.csv.x-0.tmp",
                                    ".a.csv.-3-0.tmp"};
  for (const std::string& name : stays) std::ofstream(scratch / name) << "x";
  std::ofstream(scratch / (".a.csv." + dead + "-12.tmp")) << "x";
  std::ofstream(scratch / (".with.dots-and-0.dashes." + dead + "-12.tmp")) << "x";
  // Of a process before this one that had its number.
  std::ofstream(temporary_name(scratch / "b.csv", 0)) << "x";
  remove_stale_temporaries(scratch.path());
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(scratch.path())) left.insert(entry.path().filename().string());
  EXPECT_EQ(left, stays);
}

TEST(TemporaryFiles, AreTheOnesThatAKilledWriterLeaves) {
  const ScratchFolder scratch;
  const pid_t child = ::fork();
  if (child == 0) {
    AtomicFile file(scratch / "frame.ply");
    file.stream() << "half" << std::flush;
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(fs::is_empty(scratch.path()));
  remove_stale_temporaries(scratch.path());
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(TemporaryFiles, OfAProcessThatIsKilledAndNotYetWaitedForAreStale) {
  const ScratchFolder scratch;
  const pid_t child = ::fork();
  if (child == 0) {
    AtomicFile file(scratch / "frame.ply");
    file.stream() << "half" << std::flush;
    ::raise(SIGKILL);
  }
  siginfo_t ended{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);  // it stays a zombie
  EXPECT_FALSE(fs::is_empty(scratch.path()));
  remove_stale_temporaries(scratch.path());
  EXPECT_TRUE(fs::is_empty(scratch.path()));
  ::waitpid(child, nullptr, 0);
}

TEST(TemporaryFiles, AreNotLookedForInAFolderThatIsNotThere) {
  EXPECT_NO_THROW(remove_stale_temporaries("/nowhere"));
}

}  // namespace
}  // namespace base
