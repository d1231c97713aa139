#include "FoamSim/sheet/pressure/pressure_scheme.h"

#include <algorithm>

namespace foamsim {

double Pressures::at(const SurfaceGeometry& geometry, lostopos::Vertex v, lostopos::Region r) const {
  const auto regions = geometry.regions(v);
  const auto it = std::ranges::lower_bound(regions, r);
  if (it == regions.end() || *it != r) return 0;
  return values[geometry.first_entry(v) + static_cast<std::size_t>(it - regions.begin())];
}

}  // namespace foamsim
