#include "FoamSim/render/png.h"

#include <png.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "Base/error.h"
#include "Base/io/atomic_file.h"

namespace foamsim::render {
namespace {

bool is_opaque(const Image& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(), [](const Pixel& p) { return p[3] == 255; });
}

std::vector<std::uint8_t> pack(const Image& image, int channels) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels().size() * channels);
  for (const Pixel& p : image.pixels()) bytes.insert(bytes.end(), p.begin(), p.begin() + channels);
  return bytes;
}

std::vector<std::uint8_t> encode(const Image& image) {
  const bool opaque = is_opaque(image);
  const std::vector<std::uint8_t> pixels = pack(image, opaque ? 3 : 4);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::uint8_t> bytes(size);
  const bool done = png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels.data(), 0, nullptr) != 0;
  const std::string message = header.message;
  png_image_free(&header);
  if (!done) throw base::Error("cannot make a picture: " + message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  if (image.empty()) throw base::InputError("cannot write picture " + path.string() + ": it has no pixels");
  const std::vector<std::uint8_t> bytes = encode(image);
  base::AtomicFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

}  // namespace foamsim::render
