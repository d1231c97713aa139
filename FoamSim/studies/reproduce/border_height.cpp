#include "FoamSim/studies/reproduce/border_height.h"

#include "LosTopos/mesh/measures.h"

namespace foamsim {

double mean_border_height(const lostopos::SurfaceMesh& mesh) {
  double sum = 0;
  std::size_t count = 0;
  for (lostopos::Vertex v : mesh.vertices()) {
    double length = 0, area = 0;
    for (lostopos::Edge e : mesh.edges(v))
      if (mesh.triangles(e).size() == 3) length += lostopos::length(mesh, e) / 2;
    if (length == 0) continue;
    for (lostopos::Triangle t : mesh.triangles(v)) area += lostopos::area(mesh, t);
    sum += 2.0 / 9.0 * area / length;
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace foamsim
