#include "FoamSim/sheet/pressure/vertex_area/constant_edge.h"

#include <algorithm>

namespace foamsim {

void ConstantEdgeArea::evaluate(const VertexStar& star, std::span<double> area) const {
  if (!star.junction) {
    area_of_own_triangles(star, area);
    return;
  }
  double junction_length = 0;
  for (lostopos::Edge e : star.mesh.edges(star.vertex))
    if (star.mesh.is_junction(e)) junction_length += star.geometry.length(e);
  const double mean_edge = resolution_ > 0 ? resolution_ : star.geometry.mean_edge_length();
  std::ranges::fill(area, phi_ * mean_edge * junction_length);
}

}  // namespace foamsim
