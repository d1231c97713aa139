#include "Base/io/atomic_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "LosTopos/io/ply.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class AtomicFileTest : public IoTest {};

// Files of this process cannot grow beyond the limit while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST_F(AtomicFileTest, AppearsOnCommitOnly) {
  base::AtomicFile file(path("a.csv"));
  file.stream() << "1,2\n" << 1234567 << ',' << 0.5;
  file.stream().flush();
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
  file.commit();
  EXPECT_EQ(content_of(path("a.csv")), "1,2\n1234567,0.5");
  EXPECT_EQ(files_in_folder(), 1U);
  EXPECT_NO_THROW(file.commit());
}

TEST_F(AtomicFileTest, WithoutCommitTheOldContentStays) {
  write("a.csv", "old");
  {
    base::AtomicFile file(path("a.csv"));
    file.stream() << "new";
  }
  EXPECT_EQ(content_of(path("a.csv")), "old");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(AtomicFileTest, TwoAtOnceForOnePathDoNotMix) {
  base::AtomicFile first(path("a")), second(path("a"));
  first.stream() << "first";
  second.stream() << "second";
  first.commit();
  EXPECT_EQ(content_of(path("a")), "first");
  second.commit();
  EXPECT_EQ(content_of(path("a")), "second");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(AtomicFileTest, LargeContentIsWhole) {
  std::string expected;
  base::AtomicFile file(path("a"));
  for (int i = 0; i < 100000; ++i) {
    const std::string piece = std::to_string(i) + std::string(static_cast<std::size_t>(i % 7), 'x');
    expected += piece;
    file.stream() << piece;
  }
  const std::string block(1000000, 'y');  // larger than any buffer
  file.stream() << block << 'z';
  file.commit();
  EXPECT_EQ(content_of(path("a")), expected + block + 'z');
}

TEST_F(AtomicFileTest, FullDeviceIsReportedWithPathAndReason) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  base::AtomicFile file("/dev/full");
  file.stream() << "something";
  const std::string message = input_error([&] { file.commit(); });
  expect_contains(message, "/dev/full");
  expect_contains(message, "No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(AtomicFileTest, DeviceIsWrittenNotReplaced) {
  base::AtomicFile file("/dev/null");
  file.stream() << "something";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, FileSizeLimitIsAnErrorAndLeavesNothing) {
  write("a", "old");
  const FileSizeLimit limit(100000);
  {
    base::AtomicFile file(path("a"));
    for (int i = 0; i < 100000; ++i) file.stream() << "0123456789";
    EXPECT_TRUE(file.stream().bad());
    const std::string message = input_error([&] { file.commit(); });
    expect_contains(message, path("a").string());
    expect_contains(message, "File too large");
  }
  EXPECT_EQ(content_of(path("a")), "old");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(AtomicFileTest, FileSizeLimitReachesTheCallerOfAWriter) {
  SurfaceData data;
  data.positions.assign(10000, Vec3::Ones());
  const FileSizeLimit limit(100000);
  EXPECT_THROW(write_ply(path("a.ply"), data), base::FileError);
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(AtomicFileTest, ClosedPipeIsAnErrorNotASignal) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int both_ends = ::open(path("pipe").c_str(), O_RDWR | O_CLOEXEC);  // does not wait for a reader
  ASSERT_GE(both_ends, 0);
  base::AtomicFile file(path("pipe"));
  ::close(both_ends);
  file.stream() << "nobody listens";
  expect_contains(input_error([&] { file.commit(); }), "Broken pipe");
}

TEST_F(AtomicFileTest, SignalMaskIsPutBack) {
  sigset_t before, after;
  pthread_sigmask(SIG_BLOCK, nullptr, &before);
  {
    base::AtomicFile file(path("a"));
    file.stream() << "x";
    file.commit();
  }
  pthread_sigmask(SIG_BLOCK, nullptr, &after);
  for (const int signal : {SIGXFSZ, SIGPIPE}) EXPECT_EQ(sigismember(&before, signal), sigismember(&after, signal));
}

TEST_F(AtomicFileTest, AFullDiskIsNotABadPath) {
  const auto writes = [](const std::filesystem::path& to) {
    base::AtomicFile file(to, base::Durability::machine);
    file.stream() << std::string(200000, 'x');
    file.commit();
  };
  EXPECT_THROW(writes("/dev/full"), base::DiskError);
  {
    const FileSizeLimit limit(100000);
    EXPECT_THROW(writes(path("a")), base::DiskError);
  }
  try {
    writes(path("none/a"));
    FAIL();
  } catch (const base::DiskError&) {
    FAIL() << "the path is wrong";
  } catch (const base::FileError&) {
  }
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(AtomicFileTest, CanWaitForTheDisk) {
  for (const char* name : {"a", "a"}) {
    base::AtomicFile file(path(name), base::Durability::machine);
    file.stream() << "on the disk";
    file.commit();
  }
  EXPECT_EQ(content_of(path("a")), "on the disk");
  EXPECT_EQ(files_in_folder(), 1U);
  base::AtomicFile device("/dev/null", base::Durability::machine);
  device.stream() << "nowhere";
  EXPECT_NO_THROW(device.commit());
}

TEST_F(AtomicFileTest, MissingFolder) {
  const std::string message = input_error([&] { base::AtomicFile file(path("none/a")); });
  expect_contains(message, "none/a");
  expect_contains(message, "No such file or directory");
}

TEST_F(AtomicFileTest, FolderAsTarget) {
  EXPECT_THROW(base::AtomicFile{folder_}, base::FileError);
  EXPECT_THROW(base::AtomicFile{folder_ / ""}, base::FileError);
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(AtomicFileTest, SymbolicLinkStaysAndItsTargetIsReplaced) {
  std::filesystem::create_directory(path("data"));
  write("data/real", "old");
  std::filesystem::create_symlink("data/real", path("link"));
  base::AtomicFile file(path("link"));
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(content_of(path("data/real")), "new");
}

TEST_F(AtomicFileTest, PermissionsFollowTheOldFileOrTheMask) {
  write("a", "old");
  std::filesystem::permissions(path("a"), std::filesystem::perms(0640));
  for (const char* name : {"a", "b"}) {
    base::AtomicFile file(path(name));
    file.commit();
  }
  EXPECT_EQ(std::filesystem::status(path("a")).permissions(), std::filesystem::perms(0640));
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(std::filesystem::status(path("b")).permissions(), std::filesystem::perms(0666 & ~mask));
}

TEST_F(AtomicFileTest, StreamThatThrowsStillReportsAFileError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  base::AtomicFile file("/dev/full");
  file.stream().exceptions(std::ios::badbit);
  file.stream() << "x";
  EXPECT_THROW(file.commit(), base::FileError);
}

TEST_F(AtomicFileTest, NamesNearTheLongestAllowed) {
  const std::string name(255, 'n');
  base::AtomicFile file(path(name));
  file.commit();
  EXPECT_TRUE(std::filesystem::exists(path(name)));
}

}  // namespace
}  // namespace lostopos
