#pragma once

#include <array>
#include <cstddef>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"

namespace foamsim {

/// Points of a grid along x, y and z; x is outermost in arrays.
using GridShape = std::array<std::size_t, 3>;
inline std::size_t grid_size(const GridShape& shape) {
  return shape[0] * shape[1] * shape[2];
}

/// Adds Σ m(0, i, a) m(1, j, b) m(2, k, c) in[a][b][c] to out[i][j][k]: a matrix along each axis, from a grid of shape
/// `from` to one of shape `to`, neither with more than most_nodes along an axis. `in` and `out` do not overlap.
template <class Real, class Matrix>
void contract(const Real* in, const GridShape& from, const Matrix& m, const GridShape& to, Real* out) {
  constexpr std::size_t most = most_nodes * most_nodes * most_nodes;
  std::array<Real, most> first{}, second{};
  const std::size_t plane = from[1] * from[2];
  for (std::size_t i = 0; i < to[0]; ++i)
    for (std::size_t a = 0; a < from[0]; ++a) {
      const Real weight = static_cast<Real>(m(0, i, a));
      for (std::size_t j = 0; j < plane; ++j) first[i * plane + j] += weight * in[a * plane + j];
    }
  for (std::size_t x = 0; x < to[0]; ++x)
    for (std::size_t i = 0; i < to[1]; ++i)
      for (std::size_t b = 0; b < from[1]; ++b) {
        const Real weight = static_cast<Real>(m(1, i, b));
        const Real* row = first.data() + (x * from[1] + b) * from[2];
        for (std::size_t j = 0; j < from[2]; ++j) second[(x * to[1] + i) * from[2] + j] += weight * row[j];
      }
  for (std::size_t row = 0; row < to[0] * to[1]; ++row)
    for (std::size_t c = 0; c < from[2]; ++c) {
      const Real value = second[row * from[2] + c];
      for (std::size_t i = 0; i < to[2]; ++i) out[row * to[2] + i] += static_cast<Real>(m(2, i, c)) * value;
    }
}

}  // namespace foamsim
