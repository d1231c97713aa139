#include "LosTopos/collision/rounded_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lostopos {
namespace {

// Boxes of many sizes, a half of them on a lattice, so that many just touch; some beyond single precision.
class Boxes {
 public:
  Box next() {
    const double unit = std::exp2(pick(20) == 0 ? 300 : std::uniform_int_distribution(-2, 2)(random_));
    Vec3 low, size;
    for (int i = 0; i < 3; ++i) {
      low[i] = std::uniform_real_distribution(-4.0, 4.0)(random_);
      size[i] = std::uniform_real_distribution(0.0, 3.0)(random_);
    }
    if (pick(2) == 0) {
      low = low.array().round();
      size = size.array().round();
    }
    return {unit * low, unit * (low + size)};
  }
  int pick(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

 private:
  std::mt19937 random_{3};
};

TEST(RoundedBox, MayMeetWhateverTheBoxesOverlap) {
  Boxes boxes;
  int overlapping = 0, told_apart = 0;
  constexpr int most = 20'000;
  for (int i = 0; i < most; ++i) {
    const Box a = boxes.next(), b = boxes.next(), c = boxes.next();
    const Box bc{b.low.cwiseMin(c.low), b.high.cwiseMax(c.high)};
    const RoundedBox rounded(a, 1);
    RoundedBox united(b, 2);
    united.unite(RoundedBox(c, 3));
    EXPECT_FALSE(united.is_clear());
    if (a.overlaps(bc)) {
      ++overlapping;
      EXPECT_TRUE(rounded.may_meet(united)) << a.low.transpose() << " and " << bc.low.transpose();
      EXPECT_TRUE(united.may_meet(rounded));
    } else if (!rounded.may_meet(united)) {
      ++told_apart;
    }
  }
  EXPECT_GT(overlapping, most / 10);
  // They are larger by a ten-millionth only.
  EXPECT_GT(told_apart, 9 * (most - overlapping) / 10);
}

TEST(RoundedBox, MeetsNothingWhenItIsClear) {
  RoundedBox box({Vec3(0, 0, 0), Vec3(1, 1, 1)}, 1);
  const RoundedBox other = box;
  EXPECT_TRUE(box.may_meet(other));
  box.clear();
  EXPECT_TRUE(box.is_clear());
  EXPECT_FALSE(box.may_meet(other));
}

}  // namespace
}  // namespace lostopos
