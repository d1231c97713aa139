#pragma once

#include <span>

#include "LosTopos/remeshing/operation_events.h"

namespace lostopos {

/// The displacement that a step asks of every vertex (L), carried through the operations between the step's parts: new
/// vertices get the mean of those they come from.
class CarriedMotion final : public OperationObserver {
 public:
  explicit CarriedMotion(SurfaceMesh& mesh) : motion_(mesh.add_vertex_attribute<Vec3>(Vec3::Zero())) {}

  /// Displacements to `predicted` (L, one per vertex slot). Returns the length of the longest, L.
  double set(const SurfaceMesh& mesh, std::span<const Vec3> predicted);
  const Vec3& operator[](Vertex v) const { return motion_[v]; }

  void after_split(const SurfaceMesh&, const SplitEvent& event) override;
  void before_collapse(const SurfaceMesh&, const CollapseEvent& event) override;
  void after_merge(const SurfaceMesh&, const MergeEvent& event) override;
  void after_separation(const SurfaceMesh&, const SeparationEvent& event) override;

 private:
  Vec3 at(const Place& place) const;

  VertexAttribute<Vec3> motion_;
};

}  // namespace lostopos
