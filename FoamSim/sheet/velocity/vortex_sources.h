#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <cstddef>
#include <vector>

#include "LosTopos/vec3.h"

namespace foamsim {

/// The point vortices that stand for the sheet's triangles: source t sits at the barycentre m_t = (x, y, z)[t] (unit L)
/// and has the strength γ_t = (gx, gy, gz)[t] (unit L³/T, sheet strength times area).
///
/// One array a component, because the summations stream through them; all six have the same length. Meant to be kept
/// from step to step: resize() does not give memory back.
struct VortexSources {
  using Array = std::vector<double, tbb::cache_aligned_allocator<double>>;

  Array x, y, z;
  Array gx, gy, gz;

  std::size_t size() const { return x.size(); }

  /// Make room for n sources. Those up to min(old, new) size stay as they are, new ones are zero.
  void resize(std::size_t n) {
    for (Array* array : {&x, &y, &z, &gx, &gy, &gz}) array->resize(n);
  }

  /// Set source t < size(). Different t may be set from different threads at once.
  void set(std::size_t t, const lostopos::Vec3& point, const lostopos::Vec3& strength) {
    x[t] = point.x();
    y[t] = point.y();
    z[t] = point.z();
    gx[t] = strength.x();
    gy[t] = strength.y();
    gz[t] = strength.z();
  }
};

}  // namespace foamsim
