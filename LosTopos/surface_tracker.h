#pragma once

#include <memory>
#include <span>
#include <vector>

#include "LosTopos/collision/safe_move.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/operation_events.h"
#include "LosTopos/remeshing/remesh_options.h"
#include "LosTopos/remeshing/remesh_statistics.h"

namespace lostopos {

/// How a SurfaceTracker moves and remeshes; the defaults are METHOD's.
struct TrackerOptions {
  double resolution = 0;            ///< target mean edge length h̄, L, > 0
  bool collisions = true;           ///< keep the surface from intersecting itself; false: move it where it is sent
  double proximity_epsilon = 1e-4;  ///< over h̄: nearer elements are pushed apart
  int impulse_passes = 5;           ///< see MoveOptions
  int zone_passes = 15;
  int rigid_passes = 40;
  double smallest_step = 1.0 / 64;
  double largest_motion = 20;    ///< over h̄: a step that moves a vertex farther is not resolved, and refused
  bool remeshing = true;         ///< false: `remesh` does nothing
  int remeshing_iterations = 1;  ///< passes a call of `remesh`
  RemeshOptions remesh = {};     ///< its target_edge is set from `resolution`
};

/// Moves a labelled surface to where a simulation predicts it to be without letting it intersect itself, and keeps its
/// triangles well shaped: the one class that a simulation talks to.
class SurfaceTracker {
 public:
  /// Throws InputError for options out of range.
  explicit SurfaceTracker(SurfaceMesh mesh, const TrackerOptions& options = {});

  const SurfaceMesh& mesh() const { return mesh_; }
  /// For data that is attached to the mesh (attributes).
  SurfaceMesh& mesh() { return mesh_; }
  const TrackerOptions& options() const { return options_; }

  /// Not zero: the vertex is moved by its prediction only, never by collisions or remeshing.
  VertexAttribute<char>& held() { return held_; }

  /// Is told of every operation of `remesh`; must live as long as it is called.
  void add_observer(OperationObserver& observer) { observers_.push_back(&observer); }

  /// Moves every living vertex in a straight line to, or near, its entry of `predicted` (L, indexed by vertex handle,
  /// one per slot). Throws MotionError, with the mesh as it was, when a prediction is not finite or too far
  /// away, or no motion without intersection is found.
  MoveResult advance(std::span<const Vec3> predicted);

  /// Splits, collapses, flips and smooths towards the resolution, then closes gaps in the numbering when there are
  /// many.
  RemeshStatistics remesh();

 private:
  void require_resolved(std::span<const Vec3> predicted) const;

  SurfaceMesh mesh_;
  TrackerOptions options_;
  VertexAttribute<char> held_;
  std::vector<OperationObserver*> observers_;
};

}  // namespace lostopos
