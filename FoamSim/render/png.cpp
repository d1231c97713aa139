#include "FoamSim/render/png.h"

#include <fcntl.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "Base/error.h"

namespace foamsim::render {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw base::FileError("cannot write picture " + path.string() + ": " + why);
}

bool is_opaque(const Image& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(), [](const Pixel& p) { return p[3] == 255; });
}

std::vector<std::uint8_t> pack(const Image& image, int channels) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels().size() * channels);
  for (const Pixel& p : image.pixels()) bytes.insert(bytes.end(), p.begin(), p.begin() + channels);
  return bytes;
}

// Encodes and writes; returns what went wrong, empty if nothing.
std::string encode(const Image& image, std::FILE* file) {
  const bool opaque = is_opaque(image);
  const std::vector<std::uint8_t> bytes = pack(image, opaque ? 3 : 4);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const int ok = png_image_write_to_stdio(&header, file, 0, bytes.data(), 0, nullptr);
  std::string message = ok ? "" : header.message;
  png_image_free(&header);
  return message;
}

// Opens a file beside `path` that nobody else has; bounded tries, since a stale name may be left by a killed run.
int open_temporary(const fs::path& path, fs::path& temporary) {
  for (int i = 0; i < 100; ++i) {
    temporary = path;
    temporary += ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(i);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

// Writes and closes; returns what went wrong, empty if nothing.
std::string write_and_close(const Image& image, int fd) {
  std::FILE* file = ::fdopen(fd, "wb");
  if (file == nullptr) {
    ::close(fd);
    return std::strerror(errno);
  }
  std::string message = encode(image, file);
  if (message.empty() && std::fflush(file) != 0) message = std::strerror(errno);
  if (std::fclose(file) != 0 && message.empty()) message = std::strerror(errno);
  return message;
}

}  // namespace

void write_png(const Image& image, const fs::path& path) {
  if (image.empty()) throw base::InputError("cannot write picture " + path.string() + ": it has no pixels");
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (fs::is_directory(status)) fail(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd < 0) fail(path, std::strerror(errno));
    if (const std::string message = write_and_close(image, fd); !message.empty()) fail(path, message);
    return;
  }
  // Through a symbolic link the target is replaced, not the link.
  const bool replaces = fs::exists(status);
  const fs::path target = replaces ? fs::canonical(path, code) : path;
  if (replaces && code) fail(path, code.message());
  fs::path temporary;
  const int fd = open_temporary(target, temporary);
  if (fd < 0) fail(path, std::strerror(errno));
  std::string message = write_and_close(image, fd);
  if (message.empty() && std::rename(temporary.c_str(), target.c_str()) != 0) message = std::strerror(errno);
  if (!message.empty()) {
    ::unlink(temporary.c_str());
    fail(path, message);
  }
}

}  // namespace foamsim::render
