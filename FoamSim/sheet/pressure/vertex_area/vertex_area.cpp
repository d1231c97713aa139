#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

#include <algorithm>

namespace foamsim {

void area_of_own_triangles(const VertexStar& star, std::span<double> area) {
  std::ranges::fill(area, 0.0);
  for (lostopos::Triangle t : star.mesh.triangles(star.vertex)) {
    const lostopos::Labels labels = star.mesh.labels(t);
    for (lostopos::Region r : {labels.p, labels.q})
      area[std::ranges::lower_bound(star.regions, r) - star.regions.begin()] += star.geometry.area(t) / 3;
  }
}

}  // namespace foamsim
