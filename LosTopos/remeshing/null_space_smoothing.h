#pragma once

#include <optional>

#include "LosTopos/remeshing/remesh_context.h"

namespace lostopos {

/// Moves a vertex so that its triangles become rounder, in the null space of the quadric of its triangles' normals
/// (Jiao 2007, "Face offsetting: a unified approach for explicit moving interfaces"): tangentially within a film, along
/// the curve on a border or a crease, not at all at a corner. Within that space it moves so that no region's volume
/// changes (volumes are linear in the position of one vertex). Done when the star's smallest angle grows.
class NullSpaceSmoothing {
 public:
  explicit NullSpaceSmoothing(RemeshContext& context) : c_(context) {}

  /// Whether v can be moved to advantage: nothing, or why not. The mesh stays as it is.
  std::optional<Refusal> check(Vertex v);
  /// Moves v, or says why not and leaves the mesh as it was.
  std::optional<Refusal> attempt(Vertex v);

 private:
  void plan_star(Vertex v);
  std::optional<Refusal> plan_move(Vertex v, const Vec3& target);
  bool improves_smallest_angle();
  std::optional<Refusal> refuse(Vertex v, Refusal why);

  RemeshContext& c_;
  Vec3 target_ = Vec3::Zero();
  std::size_t sharpest_ = 0;  // of the planned triangles: the one with the smallest angle before
};

}  // namespace lostopos
