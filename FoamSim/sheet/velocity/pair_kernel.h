#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <cstddef>
#include <vector>

namespace foamsim {

/// How many triangles make up a row; arrays handed to the kernel are padded to a multiple of it.
constexpr std::size_t pair_row = 32;

/// Components that a triangle collects: Ψ (3), and with all terms B (3) and u (3).
constexpr std::size_t potential_components = 3, all_components = 9;

/// Barycentres and strengths as the kernel reads them: one array a component, padded to a multiple of pair_row by
/// triangles without strength.
template <class Real>
struct PairBodies {
  using Array = std::vector<Real, tbb::cache_aligned_allocator<Real>>;
  Array x, y, z, gx, gy, gz;
};

/// Adds, 4π times, what the pairs (t, s) with t in row `row` and s > t give to both to `out`: component c of triangle t
/// at out[c · stride + t], `stride` the padded number of triangles. One thread, the best instruction set of the
/// machine. In single precision pairs and the sums over a row are, not those over rows.
void add_pair_row(const PairBodies<double>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride);
void add_pair_row(const PairBodies<float>& bodies, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride);

}  // namespace foamsim
