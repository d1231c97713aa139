#pragma once

#include "LosTopos/mesh/attribute_codec.h"
#include "LosTopos/vec3.h"

namespace lostopos {

/// What of a vertex's motion is prescribed, a set of coordinates: these end where the motion asks them to, and neither
/// collisions nor remeshing change them. A vertex on a wall x = const has `Hold::x`; one in the crease between two
/// walls has both of theirs; `Hold::all` holds the whole vertex (a wire).
enum class Hold : std::uint8_t { none = 0, x = 1, y = 2, z = 4, all = 7 };

/// What either holds.
constexpr Hold operator|(Hold a, Hold b) {
  return static_cast<Hold>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// What both hold.
constexpr Hold operator&(Hold a, Hold b) {
  return static_cast<Hold>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}
constexpr Hold& operator|=(Hold& a, Hold b) {
  return a = a | b;
}

/// That of coordinate i (0, 1, 2) alone.
constexpr Hold hold_of_coordinate(int i) {
  return static_cast<Hold>(1U << static_cast<unsigned>(i));
}
/// Whether all of the vertex is held.
constexpr bool is_held(Hold hold) {
  return hold == Hold::all;
}
/// Whether coordinate i (0, 1, 2) is held.
constexpr bool holds(Hold hold, int i) {
  return (hold & hold_of_coordinate(i)) != Hold::none;
}
constexpr bool holds_all_of(Hold hold, Hold other) {
  return (hold & other) == other;
}
/// How many coordinates are held.
constexpr int held_count(Hold hold) {
  return (holds(hold, 0) ? 1 : 0) + (holds(hold, 1) ? 1 : 0) + (holds(hold, 2) ? 1 : 0);
}

/// A displacement without its held coordinates.
inline Vec3 free_part(Hold hold, Vec3 d) {
  for (int i = 0; i < 3; ++i)
    if (holds(hold, i)) d[i] = 0;
  return d;
}

/// The held coordinates that two points have in common: both hold them, at the same value to the bit. So two vertices
/// in one wall share its coordinate, two in opposite walls do not.
inline Hold common_hold(Hold a, const Vec3& at_a, Hold b, const Vec3& at_b) {
  Hold common = Hold::none;
  for (int i = 0; i < 3; ++i)
    if (holds(a, i) && holds(b, i) && at_a[i] == at_b[i]) common |= hold_of_coordinate(i);
  return common;
}

/// As a number: 1 for x, 2 for y, 4 for z, added up.
template <>
struct AttributeCodec<Hold> : PlainCodec<Hold> {
  static std::string type() { return "hold"; }
  static std::optional<std::vector<Hold>> decode(std::span<const std::uint8_t> bytes) {
    for (std::uint8_t byte : bytes)
      if (byte > static_cast<std::uint8_t>(Hold::all)) return {};
    return PlainCodec<Hold>::decode(bytes);
  }
  static constexpr int components = 1;
  static double number(Hold value, int) { return static_cast<double>(value); }
};

}  // namespace lostopos
