// Every reader survives what libFuzzer begins with, and files made from it at random: the same ones each time. What it
// was once ended by has a test of its own, beside its other tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/corpus.h"
#include "tests/fuzz/harnesses.h"
#include "tests/support/scratch_folder.h"

namespace fuzz {

// GoogleTest's name for it.
void PrintTo(const Harness& harness, std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << harness.name;
}

namespace {

using Bytes = std::vector<std::uint8_t>;
using Random = std::mt19937_64;

class FedReader : public testing::TestWithParam<Harness> {
 protected:
  void SetUp() override {
    write_corpus(scratch_.path());
    for (const auto& file : std::filesystem::directory_iterator(scratch_.path() / GetParam().name)) {
      std::ifstream in(file.path(), std::ios::binary);
      corpus_.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    std::ranges::sort(corpus_);  // a folder has no order
    ASSERT_FALSE(corpus_.empty());
  }

  const Bytes& any(Random& random) const { return corpus_[random() % corpus_.size()]; }

  std::vector<Bytes> corpus_;

 private:
  const test::ScratchFolder scratch_;
};

std::size_t place_in(const Bytes& bytes, Random& random) {
  return bytes.empty() ? 0 : random() % bytes.size();
}

void change_a_byte(Bytes& bytes, Random& random) {
  constexpr std::string_view strange = "0123456789-.eE \n/<>[]{}\"'=#,:&\0\x7f\xff";
  if (bytes.empty()) return;
  std::uint8_t& byte = bytes[place_in(bytes, random)];
  byte =
      static_cast<std::uint8_t>(random() % 2 == 0 ? byte ^ (1U << (random() % 8)) : strange[random() % strange.size()]);
}

// A number that overflows a product, a sum, or memory.
void put_a_number(Bytes& bytes, Random& random) {
  constexpr std::uint64_t numbers[] = {0, 1, 0x7fffffff, 0xffffffff, 1ULL << 32U, 1ULL << 60U, 1ULL << 63U, ~0ULL};
  if (bytes.size() < sizeof(std::uint64_t)) return;
  const std::uint64_t number = numbers[random() % std::size(numbers)];
  std::memcpy(bytes.data() + random() % (bytes.size() - sizeof(number) + 1), &number, sizeof(number));
}

// Puts up to 64 bytes of another file, or none, in the place of up to 64.
void exchange_a_piece(Bytes& bytes, const Bytes& other, Random& random) {
  constexpr std::size_t longest = 65;
  const std::size_t to = place_in(bytes, random), from = place_in(other, random);
  const std::size_t taken = std::min<std::size_t>(random() % longest, bytes.size() - to);
  const std::size_t put = random() % 2 == 0 ? 0 : std::min<std::size_t>(random() % longest, other.size() - from);
  const Bytes piece(other.begin() + static_cast<long>(from), other.begin() + static_cast<long>(from + put));
  bytes.erase(bytes.begin() + static_cast<long>(to), bytes.begin() + static_cast<long>(to + taken));
  bytes.insert(bytes.begin() + static_cast<long>(to), piece.begin(), piece.end());
}

TEST_P(FedReader, ReadsTheCorpusAndRefusesNothing) {
  for (const Bytes& bytes : corpus_) EXPECT_TRUE(GetParam().feed(bytes)) << std::string(bytes.begin(), bytes.end());
  EXPECT_FALSE(GetParam().feed({}));
}

TEST_P(FedReader, SurvivesTheCorpusCutShort) {
  for (const Bytes& bytes : corpus_)
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 500)
      EXPECT_NO_THROW(GetParam().feed(std::span(bytes).first(size))) << "cut to " << size;
}

TEST_P(FedReader, SurvivesChangedFiles) {
  constexpr int files = 5000, most_changes = 6;
  Random random(20240311);
  for (int i = 0; i < files; ++i) {
    Bytes bytes = any(random);
    for (std::uint64_t left = 1 + random() % most_changes; left > 0; --left) {
      const std::uint64_t kind = random() % 4;
      if (kind < 2) change_a_byte(bytes, random);
      if (kind == 2) put_a_number(bytes, random);
      if (kind == 3) exchange_a_piece(bytes, any(random), random);
    }
    EXPECT_NO_THROW(GetParam().feed(bytes)) << "file " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, FedReader, testing::ValuesIn(harnesses().begin(), harnesses().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace fuzz
