#include "Base/parallel/ranks.h"

#include <gtest/gtest.h>

#include <vector>

namespace base {
namespace {

TEST(Ranks, OneAloneHasAllOfTheWork) {
  const auto one = alone();
  EXPECT_EQ(one->share(7), (std::pair<std::size_t, std::size_t>(0, 7)));
  std::vector<double> values{1, 2};
  one->gather(values);
  one->in_turn(values, [&values] { values[0] += 2; });
  EXPECT_EQ(values, (std::vector<double>{3, 2}));
  EXPECT_TRUE(one->any(true));
  EXPECT_FALSE(one->any(false));
}

class RankOf final : public Ranks {
 public:
  RankOf(std::size_t rank, std::size_t size) : rank_(rank), size_(size) {}
  std::size_t size() const override { return size_; }
  std::size_t rank() const override { return rank_; }
  void gather(std::span<double> /*values*/) const override {}
  void in_turn(std::span<double> /*values*/, const std::function<void()>& add) const override { add(); }
  bool any(bool here) const override { return here; }

 private:
  std::size_t rank_, size_;
};

TEST(Ranks, SharesAreAllOfIt) {
  for (std::size_t size : {1U, 2U, 3U, 16U, 20U})
    for (std::size_t count : {0U, 1U, 16U, 17U, 1000U}) {
      std::size_t next = 0;
      for (std::size_t rank = 0; rank < size; ++rank) {
        const auto [begin, end] = RankOf(rank, size).share(count);
        EXPECT_EQ(begin, next);
        EXPECT_LE(end - begin, count / size + 1);
        next = end;
      }
      EXPECT_EQ(next, count);
    }
}

}  // namespace
}  // namespace base
