#pragma once

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// The held coordinates that all vertices of the place have in common, see common_hold for two points. `held`: by
/// vertex slot.
Hold common_hold(const SurfaceMesh& mesh, std::span<const Hold> held, const Place& place);

/// How what is held of every vertex (see mesh/hold.h) follows the operations: the vertex of a split edge holds what
/// both ends hold in common, so that walls, creases and wires' ends stay what they are; two vertices that become one
/// hold what either held; copies hold the same.
class HoldTransfer final : public CarryPolicy<Vertex, Hold> {
 public:
  void before_split(const SurfaceMesh& mesh, const SplitEvent& event) override;
  void after_split(const SurfaceMesh& mesh, const SplitEvent& event) override;
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& event) override;
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& event) override;
  void after_separation(const SurfaceMesh& mesh, const SeparationEvent& event) override;

 private:
  Hold next_ = Hold::none;  // of the vertex that the operation under way makes
};

/// The attribute "hold" of a mesh.
VertexAttribute<Hold> add_hold_attribute(SurfaceMesh& mesh);

}  // namespace lostopos
