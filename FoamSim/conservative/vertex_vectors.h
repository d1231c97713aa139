#pragma once

#include <span>

#include "LosTopos/vec3.h"

namespace foamsim {

/// Σ_v a_v·b_v of vectors of the same number, in their order and on one thread: the same bits always.
inline double dot(std::span<const lostopos::Vec3> a, std::span<const lostopos::Vec3> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace foamsim
