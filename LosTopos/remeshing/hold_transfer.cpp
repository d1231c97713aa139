#include "LosTopos/remeshing/hold_transfer.h"

namespace lostopos {

void HoldTransfer::before_split(const SurfaceMesh& mesh, const SplitEvent& event) {
  const auto [a, b] = event.ends;
  next_ = common_hold(held[a], mesh.position(a), held[b], mesh.position(b));
}

void HoldTransfer::after_split(const SurfaceMesh&, const SplitEvent& event) {
  held[event.added] = next_;
}

char common_hold(const SurfaceMesh& mesh, const VertexAttribute<char>& held, const Place& place) {
  const Vertex first = place.vertices[0];
  char common = held[first];
  for (std::size_t i = 1; i < place.count; ++i) {
    const Vertex other = place.vertices[i];
    common = common_hold(common, mesh.position(first), held[other], mesh.position(other));
  }
  return common;
}

void HoldTransfer::before_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  next_ = hold_union(common_hold(mesh, held, event.places[0]), common_hold(mesh, held, event.places[1]));
}

void HoldTransfer::after_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  if (mesh.alive(event.result)) held[event.result] = next_;
}

void HoldTransfer::after_separation(const SurfaceMesh&, const SeparationEvent& event) {
  held[event.added] = held[event.vertex];
}

}  // namespace lostopos
