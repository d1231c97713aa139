#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "LosTopos/collision/box_overlap.h"
#include "LosTopos/collision/broad_phase.h"

namespace lostopos {

/// The largest number of single precision that is not above x.
inline float rounded_down(double x) {
  const float y = static_cast<float>(x);
  return static_cast<double>(y) <= x ? y : std::nextafter(y, -std::numeric_limits<float>::infinity());
}

/// The least number of single precision that is not below x.
inline float rounded_up(double x) {
  return -rounded_down(-x);
}

/// A box in single precision, rounded outwards (L).
struct RoundedBox {
  std::array<float, 3> low, high;

  void enclose(const Box& box) {
    for (int i = 0; i < 3; ++i) {
      low[static_cast<std::size_t>(i)] = rounded_down(box.low[i]);
      high[static_cast<std::size_t>(i)] = rounded_up(box.high[i]);
    }
  }
  /// Nothing overlaps it from now on.
  void clear() {
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
  }
};

/// A box to be compared with many rounded ones: most of them say themselves whether what they stand for overlaps it.
class BoxQuery {
 public:
  explicit BoxQuery(const Box& box) : box_(box) {
    outer_.enclose(box);
    for (int i = 0; i < 3; ++i) {
      inner_low_[static_cast<std::size_t>(i)] = rounded_up(box.low[i]);
      inner_high_[static_cast<std::size_t>(i)] = rounded_down(box.high[i]);
    }
  }
  const Box& box() const { return box_; }
  /// False only where the box that was rounded does not overlap.
  bool may_meet(const RoundedBox& rounded) const { return overlap(rounded, outer_); }
  /// True only where it does: its sides are less than one number of single precision within the rounded ones.
  bool surely_meets(const RoundedBox& rounded) const {
    int all = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      all &= static_cast<int>(rounded.high[i] > inner_low_[i]);
      all &= static_cast<int>(rounded.low[i] < inner_high_[i]);
    }
    return all != 0;
  }

 private:
  Box box_;
  RoundedBox outer_;
  std::array<float, 3> inner_low_, inner_high_;  // rounded inwards
};

}  // namespace lostopos
