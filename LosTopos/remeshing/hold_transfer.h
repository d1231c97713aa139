#pragma once

#include "LosTopos/mesh/hold.h"
#include "LosTopos/remeshing/operation_events.h"

namespace lostopos {

/// The held coordinates that all vertices of the place have in common, see common_hold for two points.
char common_hold(const SurfaceMesh& mesh, const VertexAttribute<char>& held, const Place& place);

/// What is held of every vertex (see mesh/hold.h), handed on through the operations: the vertex of a split edge holds
/// what both ends hold in common, so that walls, creases and wires' ends stay what they are; two vertices that become
/// one hold what either held; copies hold the same.
class HoldTransfer final : public OperationObserver {
 public:
  explicit HoldTransfer(SurfaceMesh& mesh) : held(mesh.add_vertex_attribute<char>(hold_none)) {}

  void before_split(const SurfaceMesh& mesh, const SplitEvent& event) override;
  void after_split(const SurfaceMesh& mesh, const SplitEvent& event) override;
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& event) override;
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& event) override;
  void after_separation(const SurfaceMesh& mesh, const SeparationEvent& event) override;

  VertexAttribute<char> held;

 private:
  char next_ = hold_none;  // of the vertex that the operation under way makes
};

}  // namespace lostopos
