#pragma once

#include <optional>

#include "LosTopos/remeshing/remesh_context.h"

namespace lostopos {

/// Puts a new vertex on an edge and halves every triangle there. The vertex goes to a smooth position (see
/// RemeshOptions::use_butterfly) or, when that is refused, to the midpoint. Edges between two held vertices are not
/// split: they belong to the wire or solid that holds them.
class EdgeSplit {
 public:
  explicit EdgeSplit(RemeshContext& context) : c_(context) {}

  /// Whether e can be split now: nothing, or why not. The mesh stays as it is.
  std::optional<Refusal> check(Edge e);
  /// Splits e, or says why not and leaves the mesh as it was.
  std::optional<Refusal> attempt(Edge e);
  /// The vertex that the last attempt made.
  Vertex added() const { return added_; }

 private:
  Vec3 in_common_walls(Edge e, Vec3 position) const;
  std::optional<Refusal> plan_at(Edge e, const Vec3& position);

  RemeshContext& c_;
  Vec3 position_ = Vec3::Zero();
  Vertex added_;
};

}  // namespace lostopos
