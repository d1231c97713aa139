#include "LosTopos/remeshing/remesh_context.h"

#include <algorithm>

namespace lostopos {

void RemeshContext::disturb(Triangle t) {
  for (Vertex v : mesh.vertices(t)) settled.disturb(v);
}

std::span<const TriangleSource> RemeshContext::carry_out(Vertex fresh) {
  sources_.clear();
  // All additions come first: so no slot is used again before observers have seen the last of its element, and edges
  // that stay keep their handles.
  for (PlannedTriangle& planned : plan.triangles) {
    if (planned.moved_only) continue;
    std::ranges::replace(planned.vertices, planned_vertex, fresh);
    const auto& [a, b, c] = planned.vertices;
    sources_.push_back({mesh.add_triangle(a, b, c, planned.labels), planned.parent});
    index.changed(sources_.back().child);
    disturb(sources_.back().child);
  }
  for (const PlannedTriangle& planned : plan.triangles) {
    if (!planned.moved_only) continue;
    index.changed(planned.parent);
    disturb(planned.parent);
  }
  for (Triangle t : plan.replaced) {
    disturb(t);
    const bool stays = std::ranges::any_of(
        plan.triangles, [t](const PlannedTriangle& planned) { return planned.moved_only && planned.parent == t; });
    if (stays) continue;
    index.removed(t);
    mesh.remove_triangle(t);
  }
  return sources_;
}

}  // namespace lostopos
