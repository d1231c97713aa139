#pragma once

#include <optional>

#include "LosTopos/remeshing/remesh_context.h"

namespace lostopos {

/// Turns an edge between two triangles of one film to join their other corners. Done when it makes the smallest of
/// their angles larger, which the flips of Delaunay's criterion do on a flat film; as no sequence of such flips comes
/// back to where it was, flipping ends. One end of the new edge, when it is free to, moves along its normal by as much
/// as keeps the volumes (see VolumeChange::restoring_shift).
class EdgeFlip {
 public:
  explicit EdgeFlip(RemeshContext& context) : c_(context) {}

  /// Whether the two angles opposite to e add up to more than π, with some room for rounding: the flip is worth trying.
  static bool is_wanted(const SurfaceMesh& mesh, Edge e);
  /// Whether e can be flipped now: nothing, or why not. The mesh stays as it is.
  std::optional<Refusal> check(Edge e);
  /// Flips e, or says why not and leaves the mesh as it was.
  std::optional<Refusal> attempt(Edge e);
  /// The edge that the last attempt made.
  Edge added() const { return added_; }

 private:
  std::optional<Refusal> plan_flip(Edge e);
  std::optional<Refusal> plan_shift(Edge e);

  RemeshContext& c_;
  std::array<Vertex, 2> opposite_;
  Vertex moved_;
  Vec3 position_ = Vec3::Zero();
  Edge added_;
};

}  // namespace lostopos
