// What library types of others do wrongly where memory ends, done while every single allocation fails in turn:
// std::bad_alloc, and nothing left behind.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "Base/json/binary_json.h"
#include "Base/options/option_set.h"

namespace {

struct Allocations {
  long held = 0;
  long until_failure = -1;  // negative: none fails
};
Allocations allocations;  // of the only thread

}  // namespace

// Not inlined, and with the form that does not throw: see tests/LosTopos/io/damaged_file_test.cpp.
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  if (allocations.until_failure >= 0 && allocations.until_failure-- == 0) return nullptr;
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (memory != nullptr) ++allocations.held;
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  if (void* memory = operator new(bytes, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory != nullptr) --allocations.held;
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

namespace base {
namespace {

// How many allocations `copy` makes, each of which has failed once.
template <class Copy>
long fail_each(const Copy& copy) {
  constexpr long far_more = 10000;
  for (long n = 0; n < far_more; ++n) {
    const long held = allocations.held;
    allocations.until_failure = n;
    bool failed = false;
    try {
      copy();
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    allocations.until_failure = -1;
    EXPECT_EQ(allocations.held, held) << "allocation " << n;
    if (!failed) return n;
  }
  return far_more;
}

// Something that may look at a copy, so that it has to be made.
template <class T>
[[gnu::noinline]] void take(T& /*copy*/) {}

template <class T>
long fail_each_of_a_copy(const T& value) {
  return fail_each([&value] {
    T copy = value;
    take(copy);
  });
}

// Longer than what a std::string holds within itself.
std::string long_word(char letter) {
  return std::string(50, letter);
}

TEST(WithoutMemory, AnOptionsValueIsNotCopied) {
  const OptionValue word = long_word('a'), list = Words{long_word('b'), long_word('c')};
  EXPECT_EQ(fail_each_of_a_copy(word), 1);
  EXPECT_EQ(fail_each_of_a_copy(list), 3);
  EXPECT_EQ(fail_each([&] {
              OptionValue copy = 1.0;
              copy = word;
            }),
            1);
}

TEST(WithoutMemory, ASpecAndASetAreNotCopied) {
  const OptionSpec spec = word_from(long_word('k'), long_word('a'), long_word('s'), "letters", {long_word('a'), "b"});
  EXPECT_GE(fail_each_of_a_copy(spec), 4);
  const std::vector<OptionSpec> specs{spec, flag("flag", true, "a flag"), whole_number("whole", 3, 0, "a number")};
  EXPECT_GE(fail_each_of_a_copy(specs), 6);
  const OptionSet set(specs, "tests");
  EXPECT_GE(fail_each_of_a_copy(set), 6);
}

TEST(WithoutMemory, BytesBecomeNoJson) {
  EXPECT_EQ(fail_each([] { const nlohmann::json value = binary_json(std::vector<std::uint8_t>(100, 7)); }), 2);
}

TEST(BinaryJson, HoldsTheBytes) {
  const std::vector<std::uint8_t> bytes{1, 2, 255};
  EXPECT_EQ(binary_json(bytes), nlohmann::json::binary(bytes));
  EXPECT_EQ(binary_json({}), nlohmann::json::binary({}));
}

}  // namespace
}  // namespace base
