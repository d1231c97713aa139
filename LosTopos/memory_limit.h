#pragma once

#include <cstddef>

#include "Base/options/option_set.h"

namespace lostopos {

/// How large a run is expected to become.
struct SizeEstimate {
  double triangles = 0;
  double bytes = 0;  ///< of the process, at its largest
};

/// Option `memory_limit`: what a run may take of memory, GB (10⁹ bytes); auto: 80% of what the machine has left.
base::OptionSpec memory_limit_spec();

/// The same in bytes, as it is now; infinite where the system does not say what is left.
double memory_limit(const base::OptionSet& options);

/// Triangles of edges `edge` (L) that cover `area` (L²): equilateral ones.
double triangles_on(double area, double edge);

/// Memory of a program before it has a surface.
inline constexpr double bytes_of_program = 20e6;

/// Triangles of so many bytes each that the limit has room for besides the program; at least one.
std::size_t triangles_within(double limit, double bytes_each);

/// Throws base::InputError, with the figures, where the estimate is more than `limit` bytes.
void require_memory(const SizeEstimate& size, double limit);

}  // namespace lostopos
