#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// How the number of what holds a vertex (0: nothing) follows the operations: a new vertex is free, and of two that
/// become one that which is held stays.
class WireTransfer final : public lostopos::CarryPolicy<lostopos::Vertex, std::int32_t> {
 public:
  void after_split(const lostopos::SurfaceMesh& /*mesh*/, const lostopos::SplitEvent& event) override {
    value(event.added) = 0;
  }
  void after_collapse(const lostopos::SurfaceMesh& /*mesh*/, const lostopos::CollapseEvent& event) override {
    if (value(event.kept) == 0) value(event.kept) = value(event.removed);
  }
  void before_merge(const lostopos::SurfaceMesh& /*mesh*/, const lostopos::MergeEvent& event) override {
    next_ = 0;
    for (const lostopos::Place& place : event.places)
      if (place.count == 1 && next_ == 0) next_ = value(place.vertices[0]);
  }
  void after_merge(const lostopos::SurfaceMesh& mesh, const lostopos::MergeEvent& event) override {
    if (mesh.alive(event.result)) value(event.result) = next_;
  }
  void after_separation(const lostopos::SurfaceMesh& /*mesh*/, const lostopos::SeparationEvent& event) override {
    value(event.added) = value(event.vertex);
  }

 private:
  std::int32_t next_ = 0;  // of the vertex that the merge under way makes
};

}  // namespace foamsim
