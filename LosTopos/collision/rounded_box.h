#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

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

/// Four numbers that are compared at once (GCC's and clang's vector type).
using Float4 = float __attribute__((vector_size(16)));

/// A box in single precision, rounded outwards (L), and the number of what it encloses.
class RoundedBox {
 public:
  RoundedBox() { clear(); }
  RoundedBox(const Box& box, std::uint32_t number) {
    enclose(box);
    low_[3] = std::bit_cast<float>(number);
  }
  void enclose(const Box& box) {
    for (int i = 0; i < 3; ++i) {
      low_[i] = rounded_down(box.low[i]);
      minus_high_[i] = rounded_down(-box.high[i]);
    }
  }
  /// Nothing overlaps it from now on.
  void clear() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    low_ = minus_high_ = Float4{infinity, infinity, infinity, 0};
  }
  /// Encloses what the other does as well.
  void unite(const RoundedBox& other) {
    low_ = lesser(low_, other.low_);
    minus_high_ = lesser(minus_high_, other.minus_high_);
  }
  /// False only where what was rounded does not overlap.
  bool may_meet(const RoundedBox& other) const {
    return first_three((low_ <= -other.minus_high_) & (other.low_ <= -minus_high_));
  }
  /// After clear() only: no length comes to infinity.
  bool is_clear() const { return low_[0] == std::numeric_limits<float>::infinity(); }
  std::uint32_t number() const { return std::bit_cast<std::uint32_t>(low_[3]); }

 private:
  friend class BoxQuery;
  using Mask = decltype(Float4{} <= Float4{});

  static Float4 lesser(const Float4& a, const Float4& b) { return a < b ? a : b; }
  static bool first_three(const Mask& mask) {
#ifdef __SSE__
    return (_mm_movemask_ps(std::bit_cast<__m128>(mask)) & 7) == 7;
#else
    return (mask[0] & mask[1] & mask[2]) != 0;
#endif
  }

  // With the high corner's signs changed a box overlaps another where none of these is above what the other allows. The
  // fourth of each is not compared.
  Float4 low_{}, minus_high_{};
};

/// A box to be compared with many rounded ones: most of them say themselves whether what they stand for overlaps it.
class BoxQuery {
 public:
  explicit BoxQuery(const Box& box) : box_(box) {
    for (int i = 0; i < 3; ++i) {
      most_low_[i] = rounded_up(box.high[i]);
      most_minus_high_[i] = rounded_up(-box.low[i]);
      sure_low_[i] = rounded_down(box.high[i]);
      sure_minus_high_[i] = rounded_down(-box.low[i]);
    }
  }
  const Box& box() const { return box_; }
  /// False only where the box that was rounded does not overlap.
  bool may_meet(const RoundedBox& rounded) const {
    return RoundedBox::first_three((rounded.low_ <= most_low_) & (rounded.minus_high_ <= most_minus_high_));
  }
  /// True only where it does: its sides are less than one number of single precision within the rounded ones.
  bool surely_meets(const RoundedBox& rounded) const {
    return RoundedBox::first_three((rounded.low_ < sure_low_) & (rounded.minus_high_ < sure_minus_high_));
  }

 private:
  Box box_;
  Float4 most_low_{}, most_minus_high_{};  // of boxes that may meet
  Float4 sure_low_{}, sure_minus_high_{};  // above those of boxes that surely do
};

}  // namespace lostopos
