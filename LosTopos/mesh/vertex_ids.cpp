#include "LosTopos/mesh/vertex_ids.h"

#include <limits>
#include <memory>

#include "LosTopos/error.h"

namespace lostopos {
namespace {

// New vertices have the initial value, the others their own: what a policy without hooks does.
class StaysWithItsVertex final : public CarryPolicy<Vertex, std::int32_t> {};

}  // namespace

VertexIds::VertexIds(SurfaceMesh& mesh)
    : mesh_(mesh),
      ids_(mesh.add_vertex_attribute<std::int32_t>("vertex_id", std::make_unique<StaysWithItsVertex>(), none)) {
  number_new();
}

void VertexIds::number_new() {
  for (const Vertex v : mesh_.vertices()) {
    if (ids_[v] != none) continue;
    if (given_ > std::numeric_limits<std::int32_t>::max())
      throw MeshError("no number is left for another vertex: 2^31 have been given");
    ids_[v] = static_cast<std::int32_t>(given_++);
  }
}

}  // namespace lostopos
