#include "Base/lists/erase_repeated.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace base {
namespace {

TEST(EraseRepeated, KeepsOneOfEachOfASortedList) {
  std::vector<int> list{1, 1, 2, 3, 3, 3};
  erase_repeated(list);
  EXPECT_EQ(list, (std::vector<int>{1, 2, 3}));
  erase_repeated(list);
  EXPECT_EQ(list.size(), 3u);
}

TEST(EraseRepeated, KeepsTheFirstOfNeighboursWithOneKey) {
  struct Named {
    int key;
    std::string name;
  };
  std::vector<Named> list{{1, "a"}, {1, "b"}, {2, "c"}, {1, "d"}};
  erase_repeated(list, &Named::key);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].name + list[1].name + list[2].name, "acd");
}

TEST(EraseRepeated, LeavesAnEmptyListEmpty) {
  std::vector<int> list;
  erase_repeated(list);
  EXPECT_TRUE(list.empty());
}

TEST(SortUnique, KeepsOneOfEachInOrder) {
  std::vector<int> list{3, 1, 2, 3, 1};
  sort_unique(list);
  EXPECT_EQ(list, (std::vector<int>{1, 2, 3}));
}

}  // namespace
}  // namespace base
