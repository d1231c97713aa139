#include "LosTopos/io/vtk_compression.h"

#include <gtest/gtest.h>

#include <random>

#include "LosTopos/io/byte_order.h"

namespace lostopos {
namespace {

// What a file has of an array, its two pieces of base64 decoded: sizes and as many bytes of blocks.
std::string with_header(const std::vector<std::uint64_t>& numbers, std::size_t block_bytes) {
  std::string encoded;
  for (const std::uint64_t number : numbers) append_bytes(encoded, number);
  return encoded + std::string(block_bytes, '\0');
}

std::optional<std::uint64_t> size_of(const std::string& encoded) {
  return vtk_decompressed_size(encoded, std::endian::little, true);
}

TEST(VtkCompression, SaysTheSizeOfWhatItCanHold) {
  EXPECT_EQ(size_of(with_header({0}, 0)), 0U);
  EXPECT_EQ(size_of(with_header({2, 1000, 8, 20, 10}, 30)), 1008U);
  EXPECT_EQ(size_of(with_header({2, 1000, 0, 20, 10}, 30)), 2000U) << "a last block that is full";
}

// Of several blocks each for itself: the first ones may not say what only the last one could hold, nor more.
TEST(VtkCompression, RefusesBlocksThatSayMoreThanTheirBytesStandFor) {
  EXPECT_FALSE(size_of(with_header({1, 1'000'000, 0, 20}, 20)));
  EXPECT_FALSE(size_of(with_header({2, 3'000'000'000, 8, 20, 10}, 30)));
  EXPECT_FALSE(size_of(with_header({3, std::uint64_t{1} << 62U, 8, 20, 20, 10}, 50)));
  EXPECT_FALSE(vtk_decompress(with_header({2, 3'000'000'000, 8, 20, 10}, 30), std::endian::little, true));
}

TEST(VtkCompression, NeverSaysMoreThanItsBytesStandFor) {
  constexpr std::size_t most = 64;
  std::mt19937_64 random(5);
  for (int i = 0; i < 20'000; ++i) {
    const std::size_t blocks = 1 + random() % 4;
    std::vector<std::uint64_t> header{blocks, std::uint64_t{1} << (random() % most), random() % most};
    std::size_t bytes = 0;
    for (std::size_t b = 0; b < blocks; ++b) bytes += header.emplace_back(random() % most);
    const auto size = size_of(with_header(header, bytes));
    EXPECT_LE(size.value_or(0), 1032 * bytes) << header[1] << " bytes in each of " << blocks << " blocks";
  }
}

}  // namespace
}  // namespace lostopos
