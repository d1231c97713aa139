#include "FoamSim/render/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "Base/error.h"
#include "tests/support/scratch_folder.h"

namespace foamsim::render {
namespace {

namespace fs = std::filesystem;

class PngTest : public testing::Test {
 protected:
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  const ::test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

Image noise(int width, int height, bool opaque) {
  std::mt19937 random(7);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (auto& channel : image.at(x, y)) channel = static_cast<std::uint8_t>(random());
      if (opaque) image.at(x, y)[3] = 255;
    }
  }
  return image;
}

// Reads with libpng; `channels` gets the number stored in the file.
Image read(const fs::path& path, int& channels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&header, path.c_str())) throw std::runtime_error(header.message);
  channels = PNG_IMAGE_SAMPLE_CHANNELS(header.format);
  header.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(header));
  if (!png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr)) throw std::runtime_error(header.message);
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int k = 0; k < 4; ++k) image.at(x, y)[k] = bytes[4 * (y * image.width() + x) + k];
  return image;
}

// No file may grow beyond some bytes while this lives: what a full disk looks like to a writer.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(PngTest, round_trip) {
  for (const bool opaque : {true, false}) {
    const Image image = noise(37, 21, opaque);
    write_png(image, folder_ / "a.png");
    int channels = 0;
    EXPECT_EQ(read(folder_ / "a.png", channels), image);
    EXPECT_EQ(channels, opaque ? 3 : 4);
    EXPECT_EQ(files(), 1);
  }
}

TEST_F(PngTest, a_full_disk_is_an_error_and_leaves_nothing_new) {
  const Image image = noise(200, 200, true);
  {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(write_png(image, folder_ / "a.png"), base::FileError);
  }
  EXPECT_EQ(files(), 0);
  const Image old = noise(3, 3, true);
  write_png(old, folder_ / "a.png");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(write_png(image, folder_ / "a.png"), base::FileError);
  }
  EXPECT_EQ(files(), 1);
  int channels = 0;
  EXPECT_EQ(read(folder_ / "a.png", channels), old);
}

TEST_F(PngTest, devices_are_written_to_and_stay_devices) {
  EXPECT_THROW(write_png(noise(200, 200, true), "/dev/full"), base::FileError);
  EXPECT_NO_THROW(write_png(noise(20, 20, true), "/dev/null"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(PngTest, unusable_paths_are_named_in_the_message) {
  const Image image = noise(4, 4, true);
  EXPECT_THROW(write_png(image, folder_), base::FileError);
  EXPECT_THROW(write_png(Image(), folder_ / "a.png"), base::InputError);
  try {
    write_png(image, folder_ / "missing" / "a.png");
    FAIL() << "no error";
  } catch (const base::FileError& e) {
    EXPECT_NE(std::string(e.what()).find("missing/a.png"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("No such file"), std::string::npos) << e.what();
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(PngTest, a_link_is_written_through) {
  write_png(noise(2, 2, true), folder_ / "a.png");
  fs::create_symlink("a.png", folder_ / "link.png");
  const Image image = noise(5, 4, true);
  write_png(image, folder_ / "link.png");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  int channels = 0;
  EXPECT_EQ(read(folder_ / "a.png", channels), image);
}

}  // namespace
}  // namespace foamsim::render
