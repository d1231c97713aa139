#include "LosTopos/remeshing/hold_transfer.h"

namespace lostopos {

Hold common_hold(const SurfaceMesh& mesh, std::span<const Hold> held, const Place& place) {
  const Vertex first = place.vertices[0];
  Hold common = held[first.index()];
  for (std::size_t i = 1; i < place.count; ++i) {
    const Vertex other = place.vertices[i];
    common = common_hold(common, mesh.position(first), held[other.index()], mesh.position(other));
  }
  return common;
}

void HoldTransfer::before_split(const SurfaceMesh& mesh, const SplitEvent& event) {
  const auto [a, b] = event.ends;
  next_ = common_hold(value(a), mesh.position(a), value(b), mesh.position(b));
}

void HoldTransfer::after_split(const SurfaceMesh&, const SplitEvent& event) {
  value(event.added) = next_;
}

void HoldTransfer::before_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  next_ = common_hold(mesh, values(), event.places[0]) | common_hold(mesh, values(), event.places[1]);
}

void HoldTransfer::after_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  if (mesh.alive(event.result)) value(event.result) = next_;
}

void HoldTransfer::after_separation(const SurfaceMesh&, const SeparationEvent& event) {
  value(event.added) = value(event.vertex);
}

VertexAttribute<Hold> add_hold_attribute(SurfaceMesh& mesh) {
  return mesh.add_vertex_attribute<Hold>("hold", std::make_unique<HoldTransfer>(), Hold::none);
}

}  // namespace lostopos
