#include "Base/lists/equal_entries.h"

#include <gtest/gtest.h>

namespace base {
namespace {

struct Entry {
  int key;
  char letter;
};

TEST(EqualEntries, AreThoseOfTheKeyInTheirOrder) {
  const std::vector<Entry> list{{1, 'a'}, {3, 'b'}, {3, 'c'}, {7, 'd'}};
  const auto threes = equal_entries(list, 3, &Entry::key);
  ASSERT_EQ(threes.size(), 2u);
  EXPECT_EQ(threes[0].letter, 'b');
  EXPECT_EQ(threes[1].letter, 'c');
  EXPECT_EQ(equal_entries(list, 7, &Entry::key).size(), 1u);
}

TEST(EqualEntries, AreNoneWhereTheKeyDoesNotOccur) {
  const std::vector<Entry> list{{1, 'a'}, {3, 'b'}};
  for (int key : {0, 2, 4}) EXPECT_TRUE(equal_entries(list, key, &Entry::key).empty());
  EXPECT_TRUE(equal_entries(std::vector<Entry>(), 1, &Entry::key).empty());
}

}  // namespace
}  // namespace base
