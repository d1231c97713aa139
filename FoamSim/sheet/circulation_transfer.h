#pragma once

#include <vector>

#include "FoamSim/sheet/circulation_values.h"

namespace foamsim {

/// Carries Γ through the tracker's operations (docs/method.md "Carrying data"). Split: the mean of the two
/// ends. Collapse: interpolated by where the result lies between the two vertices; a pair that only one of them had
/// comes from that one. Merge: the same between two places, each the mean of its vertices. Separation: both copies keep
/// the vertex's values, and a neighbour that gains a pair takes the vertex's value. A pair that a vertex gains from
/// nowhere: see CirculationField::match.
class CirculationTransfer final : public lostopos::CarryPolicy<lostopos::Vertex, VertexCirculation> {
 public:
  void after_split(const lostopos::SurfaceMesh& mesh, const lostopos::SplitEvent& event) override;
  void before_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_flip(const lostopos::SurfaceMesh& mesh, const lostopos::FlipEvent& event) override;
  void before_merge(const lostopos::SurfaceMesh& mesh, const lostopos::MergeEvent& event) override;
  void after_merge(const lostopos::SurfaceMesh& mesh, const lostopos::MergeEvent& event) override;
  void before_separation(const lostopos::SurfaceMesh& mesh, const lostopos::SeparationEvent& event) override;
  void after_separation(const lostopos::SurfaceMesh& mesh, const lostopos::SeparationEvent& event) override;

 private:
  void touch(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v);
  // Matches every touched vertex that is left.
  void match_touched(const lostopos::SurfaceMesh& mesh);

  VertexCirculation carried_;              // from the before-event to the after-event
  std::vector<lostopos::Vertex> touched_;  // whose triangles an operation may change
};

}  // namespace foamsim
