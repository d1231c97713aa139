#include "LosTopos/io/vtk_compression.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "Base/error.h"
#include "LosTopos/io/base64.h"
#include "LosTopos/io/byte_order.h"

namespace lostopos {
namespace {

constexpr std::size_t block_bytes = 1 << 15;  // VTK's own choice
constexpr int fast = 1;                       // twice the time gives a tenth less
constexpr std::uint64_t most_expansion = 1032;

struct BlockLayout {
  std::vector<std::uint64_t> packed;  // bytes of each block in the file
  std::uint64_t block = 0, last = 0;  // bytes of a block, and of the last one
  std::size_t begin = 0;              // where the blocks start

  std::uint64_t of_block(std::size_t i) const { return i + 1 == packed.size() ? last : block; }
  std::uint64_t of_all() const { return packed.empty() ? 0 : (packed.size() - 1) * block + last; }
};

// Checked against what is there before anything of that size is made.
std::optional<BlockLayout> read_layout(std::string_view encoded, std::endian order, bool wide) {
  const std::size_t width = wide ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
  const auto number = [&](std::size_t i) -> std::uint64_t {
    const char* at = encoded.data() + i * width;
    return wide ? number_from_bytes<std::uint64_t>(at, order) : number_from_bytes<std::uint32_t>(at, order);
  };
  BlockLayout layout;
  if (encoded.size() < width) return std::nullopt;
  const std::uint64_t blocks = number(0);
  if (blocks == 0) return layout;
  const std::uint64_t words = encoded.size() / width;
  if (words < 3 || blocks > words - 3) return std::nullopt;
  layout.block = number(1);
  layout.last = number(2) == 0 ? layout.block : number(2);
  layout.begin = static_cast<std::size_t>((3 + blocks) * width);
  if (layout.last > layout.block) return std::nullopt;
  std::uint64_t rest = encoded.size() - layout.begin;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::uint64_t packed = number(3 + i);
    if (packed > rest) return std::nullopt;
    rest -= packed;
    layout.packed.push_back(packed);
  }
  if (rest != 0) return std::nullopt;
  for (std::size_t i = 0; i < blocks; ++i)
    if (layout.of_block(i) > most_expansion * layout.packed[i]) return std::nullopt;
  return layout;
}

}  // namespace

std::string vtk_compress(std::string_view bytes) {
  const std::size_t blocks = (bytes.size() + block_bytes - 1) / block_bytes;
  std::string header, packed, block(compressBound(block_bytes), '\0');
  append_bytes(header, static_cast<std::uint64_t>(blocks));
  if (blocks > 0) {
    append_bytes(header, static_cast<std::uint64_t>(block_bytes));
    append_bytes(header, static_cast<std::uint64_t>(bytes.size() % block_bytes));
  }
  for (std::size_t begin = 0; begin < bytes.size(); begin += block_bytes) {
    const std::string_view part = bytes.substr(begin, block_bytes);
    uLongf length = block.size();
    if (compress2(reinterpret_cast<Bytef*>(block.data()), &length, reinterpret_cast<const Bytef*>(part.data()),
                  part.size(), fast) != Z_OK)
      throw base::Error("an array could not be compressed: zlib has no memory");
    append_bytes(header, static_cast<std::uint64_t>(length));
    packed.append(block, 0, length);
  }
  return base64_encode(header) + base64_encode(packed);
}

std::optional<std::uint64_t> vtk_decompressed_size(std::string_view encoded, std::endian order, bool wide_header) {
  const auto layout = read_layout(encoded, order, wide_header);
  if (!layout) return std::nullopt;
  return layout->of_all();
}

std::optional<std::string> vtk_decompress(std::string_view encoded, std::endian order, bool wide_header) {
  const auto layout = read_layout(encoded, order, wide_header);
  if (!layout) return std::nullopt;
  std::string bytes(layout->of_all(), '\0');
  std::size_t from = layout->begin, to = 0;
  for (std::size_t i = 0; i < layout->packed.size(); ++i) {
    uLongf length = layout->of_block(i);
    const uLong packed = layout->packed[i];
    if (length > 0 && (uncompress(reinterpret_cast<Bytef*>(bytes.data() + to), &length,
                                  reinterpret_cast<const Bytef*>(encoded.data() + from), packed) != Z_OK ||
                       length != layout->of_block(i)))
      return std::nullopt;
    from += packed;
    to += length;
  }
  return bytes;
}

}  // namespace lostopos
