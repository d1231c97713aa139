#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// What of a vertex's motion is prescribed, as bits of a char: such coordinates end where the motion asks them to, and
/// neither collisions nor remeshing change them. A vertex on a wall x = const has `hold_x`; one in the crease between
/// two walls has the bits of both; `hold_all` holds the whole vertex (a wire).
inline constexpr char hold_none = 0, hold_all = 1, hold_x = 2, hold_y = 4, hold_z = 8;
inline constexpr char hold_xyz = hold_x | hold_y | hold_z;

/// The coordinates alone: `hold_all` as the three bits.
constexpr char held_coordinates(char hold) {
  return (hold & hold_all) != 0 ? hold_xyz : static_cast<char>(hold & hold_xyz);
}
/// Whether all of the vertex is held.
constexpr bool is_held(char hold) {
  return held_coordinates(hold) == hold_xyz;
}
/// Whether coordinate i (0, 1, 2) is held.
constexpr bool holds(char hold, int i) {
  return (held_coordinates(hold) & (hold_x << i)) != 0;
}
constexpr bool holds_all_of(char hold, char other) {
  return (held_coordinates(other) & ~held_coordinates(hold)) == 0;
}
/// What either of two holds.
constexpr char hold_union(char a, char b) {
  return ((a | b) & hold_all) != 0 ? hold_all : static_cast<char>(a | b);
}

/// A displacement without its held coordinates.
inline Vec3 free_part(char hold, Vec3 d) {
  for (int i = 0; i < 3; ++i)
    if (holds(hold, i)) d[i] = 0;
  return d;
}

/// The held coordinates that two points have in common: both hold them, at the same value to the bit. So two vertices
/// in one wall share its coordinate, two in opposite walls do not.
inline char common_hold(char a, const Vec3& at_a, char b, const Vec3& at_b) {
  char common = 0;
  for (int i = 0; i < 3; ++i)
    if (holds(a, i) && holds(b, i) && at_a[i] == at_b[i]) common = static_cast<char>(common | (hold_x << i));
  return common;
}

}  // namespace lostopos
