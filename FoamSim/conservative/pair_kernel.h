#pragma once

#include <cstddef>

#include "FoamSim/sheet/velocity/vortex_sources.h"

namespace foamsim {

/// How many triangles make up a row; arrays handed to the kernel are padded to a multiple of it.
constexpr std::size_t pair_row = 32;

/// Components that a triangle collects: Ψ (3), and with all terms B (3) and u (3).
constexpr std::size_t potential_components = 3, all_components = 9;

/// Adds, 4π times, what the pairs (t, s) with t in row `row` and s > t give to both to `out`: component c of triangle t
/// at out[c · stride + t], `stride` the padded number of triangles. One thread, the best instruction set of the
/// machine.
void add_pair_row(const VortexSources& sources, std::size_t row, double delta_squared, bool all, double* out,
                  std::size_t stride);

}  // namespace foamsim
