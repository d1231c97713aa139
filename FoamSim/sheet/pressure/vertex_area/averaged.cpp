#include "FoamSim/sheet/pressure/vertex_area/averaged.h"

#include <algorithm>

namespace foamsim {

void AveragedArea::evaluate(const VertexStar& star, std::span<double> area) const {
  // Every triangle bounds two regions, each by a third of its area.
  double sum = 0;
  for (lostopos::Triangle t : star.mesh.triangles(star.vertex)) sum += star.geometry.area(t);
  std::ranges::fill(area, 2.0 / 3.0 * sum / static_cast<double>(star.regions.size()));
}

}  // namespace foamsim
