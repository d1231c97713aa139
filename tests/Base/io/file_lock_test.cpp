#include "Base/io/file_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "Base/error.h"
#include "tests/support/run_program.h"

namespace base {
namespace {

using ::test::ScratchFolder;

TEST(FileLock, IsHeldByOneAtATime) {
  const ScratchFolder scratch;
  std::optional<FileLock> first = FileLock::take(scratch / "lock");
  ASSERT_TRUE(first);
  EXPECT_FALSE(FileLock::take(scratch / "lock"));
  first.reset();
  EXPECT_TRUE(FileLock::take(scratch / "lock"));
}

TEST(FileLock, TellsWhoHoldsIt) {
  const ScratchFolder scratch;
  EXPECT_EQ(signature_in(scratch / "lock"), "");
  const std::optional<FileLock> lock = FileLock::take(scratch / "lock");
  lock->sign();
  EXPECT_TRUE(signature_in(scratch / "lock").starts_with("process " + std::to_string(::getpid()) + " on "));
}

// One who opened the file before it was removed would otherwise hold a lock that nobody else sees.
TEST(FileLock, HoldsWhereItsFileWasRemovedBefore) {
  const ScratchFolder scratch;
  std::optional<FileLock> first = FileLock::take(scratch / "lock");
  std::filesystem::remove(scratch / "lock");
  const std::optional<FileLock> second = FileLock::take(scratch / "lock");
  ASSERT_TRUE(second);
  first.reset();
  EXPECT_FALSE(FileLock::take(scratch / "lock"));
}

TEST(FileLock, InAFolderThatIsNotThereIsAnError) {
  const ScratchFolder scratch;
  EXPECT_THROW(FileLock::take(scratch / "none/lock"), FileError);
}

}  // namespace
}  // namespace base
