#pragma once

#include <optional>

#include "LosTopos/remeshing/remesh_context.h"

namespace lostopos {

/// Merges the two ends of an edge. The result is at the end that is bound more (held in more coordinates, then corner,
/// border, film: see VertexRank); ends that are held in different coordinates, or in different places, do not merge.
/// Between equals it is at the midpoint, shifted so that no region's volume changes: along the normal on a film, across
/// the curve on a border.
class EdgeCollapse {
 public:
  explicit EdgeCollapse(RemeshContext& context) : c_(context) {}

  /// Whether e can be collapsed now: nothing, or why not. The mesh stays as it is.
  std::optional<Refusal> check(Edge e);
  /// Collapses e, or says why not and leaves the mesh as it was.
  std::optional<Refusal> attempt(Edge e);
  /// The vertex that the last attempt kept.
  Vertex kept() const { return kept_; }

 private:
  std::optional<Refusal> choose_ends(Edge e);
  void plan_on_edge(Edge e);
  Vec3 volume_keeping_position(Edge e) const;
  bool motions_are_free(Edge e, const Vec3& on_edge);

  RemeshContext& c_;
  Vertex kept_, removed_;
  double t_ = 0;
  Vec3 position_ = Vec3::Zero();
};

}  // namespace lostopos
