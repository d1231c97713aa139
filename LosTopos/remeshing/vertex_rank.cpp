#include "LosTopos/remeshing/vertex_rank.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>

namespace lostopos {
namespace {

// Which regions meet at an edge, each as often as a film has it on a side.
boost::container::small_vector<Region, 8> regions_around(const SurfaceMesh& mesh, Edge e) {
  boost::container::small_vector<Region, 8> regions;
  for (Triangle t : mesh.triangles(e)) {
    regions.push_back(mesh.labels(t).p);
    regions.push_back(mesh.labels(t).q);
  }
  std::ranges::sort(regions);
  return regions;
}

}  // namespace

BorderEdges border_edges(const SurfaceMesh& mesh, Vertex v) {
  BorderEdges found;
  for (Edge e : mesh.edges(v)) {
    if (!is_border(mesh, e)) continue;
    if (found.count < 2) found.first[static_cast<std::size_t>(found.count)] = e;
    ++found.count;
  }
  return found;
}

VertexRank rank(const SurfaceMesh& mesh, Vertex v) {
  const BorderEdges borders = border_edges(mesh, v);
  if (borders.count == 0) return VertexRank::film;
  if (borders.count != 2) return VertexRank::corner;
  const bool same_films = regions_around(mesh, borders.first[0]) == regions_around(mesh, borders.first[1]);
  return same_films ? VertexRank::border : VertexRank::corner;
}

}  // namespace lostopos
