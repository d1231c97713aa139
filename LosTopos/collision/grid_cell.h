#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lostopos {

/// Cell coordinates are clamped to this: far away, cells grow into one.
inline constexpr double largest_cell_coordinate = 0x1p+40;

/// In which cell of a grid x lies (L; cells per L). It rises with x.
inline std::int64_t cell_coordinate(double x, double inverse_cell) {
  const double cell = std::floor(x * inverse_cell);
  if (!(cell > -largest_cell_coordinate)) return -static_cast<std::int64_t>(largest_cell_coordinate);
  return static_cast<std::int64_t>(std::min(cell, largest_cell_coordinate));
}

/// Spreads the cells of a grid with several levels evenly; different cells may have the same.
inline std::uint64_t cell_hash(int level, std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto mixed = [](std::uint64_t bits) {
    bits ^= bits >> 32;
    bits *= 0xd6e8feb86659fd93ULL;
    bits ^= bits >> 32;
    return bits;
  };
  return mixed(static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL +
               static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL +
               static_cast<std::uint64_t>(z) * 0x165667b19e3779f9ULL + static_cast<std::uint64_t>(level));
}

}  // namespace lostopos
