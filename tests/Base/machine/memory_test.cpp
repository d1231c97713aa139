#include "Base/machine/memory.h"

#include <gtest/gtest.h>

namespace base {
namespace {

TEST(Memory, IsSomeOfWhatAMachineHas) {
  const auto available = available_memory();
  ASSERT_TRUE(available);
  EXPECT_GT(*available, 1e6);
  EXPECT_LT(*available, 1e15);
}

TEST(Memory, IsSaidInWords) {
  EXPECT_EQ(bytes_in_words(0), "0 bytes");
  EXPECT_EQ(bytes_in_words(640), "640 bytes");
  EXPECT_EQ(bytes_in_words(999.6), "1 kB");
  EXPECT_EQ(bytes_in_words(1.24e6), "1.2 MB");
  EXPECT_EQ(bytes_in_words(1.56e8), "160 MB");
  EXPECT_EQ(bytes_in_words(2.1e10), "21 GB");
  EXPECT_EQ(bytes_in_words(5e18), "5000 PB");
}

}  // namespace
}  // namespace base
