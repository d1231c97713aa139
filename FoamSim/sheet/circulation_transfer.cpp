#include "FoamSim/sheet/circulation_transfer.h"

#include <algorithm>

namespace foamsim {

using lostopos::CollapseEvent;
using lostopos::FlipEvent;
using lostopos::SplitEvent;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

void CirculationTransfer::after_split(const SurfaceMesh& mesh, const SplitEvent& event) {
  circulation_.interpolate(event.added, event.ends[0], event.ends[1], 0.5);
  circulation_.match(mesh, std::span(&event.added, 1));
}

void CirculationTransfer::before_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  touched_.clear();
  for (lostopos::Edge e : mesh.edges(event.removed)) touched_.push_back(mesh.other_vertex(e, event.removed));
  circulation_.interpolate(event.kept, event.kept, event.removed, event.t);
}

void CirculationTransfer::after_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  if (std::ranges::find(touched_, event.kept) == touched_.end()) touched_.push_back(event.kept);
  circulation_.match(mesh, touched_);
}

void CirculationTransfer::after_flip(const SurfaceMesh& mesh, const FlipEvent& event) {
  const std::array<Vertex, 4> corners{event.old_ends[0], event.old_ends[1], event.new_ends[0], event.new_ends[1]};
  circulation_.match(mesh, corners);
}

}  // namespace foamsim
