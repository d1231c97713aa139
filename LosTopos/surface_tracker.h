#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "LosTopos/collision/near_triangles.h"
#include "LosTopos/collision/safe_move.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/observer_list.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/remesh_options.h"
#include "LosTopos/remeshing/remesh_statistics.h"
#include "LosTopos/topology/topology_options.h"
#include "LosTopos/topology/topology_statistics.h"

namespace lostopos {

/// How a SurfaceTracker moves and remeshes; the defaults are docs/method.md's.
struct TrackerOptions {
  double resolution = 0;            ///< target mean edge length h̄, L, > 0
  bool collisions = true;           ///< keep the surface from intersecting itself; false: move it where it is sent
  double proximity_epsilon = 1e-4;  ///< over h̄: nearer elements are pushed apart
  MoveOptions move = {};            ///< its proximity_epsilon is set from the one above
  double largest_motion = 20;       ///< over h̄: a step that moves a vertex farther is not resolved, and refused
  bool remeshing = true;            ///< false: `remesh` does nothing
  int remeshing_iterations = 1;     ///< passes a call of `remesh`
  RemeshOptions remesh = {};        ///< its target_edge is set from `resolution`, its interruption from the one below
  TopologyOptions topology = {};
  bool keep_motion = false;  ///< keep the attribute "motion" also where the topology does not change
  /// Asked within long loops; an operation that is interrupted throws base::Interrupted.
  base::Interruption interruption = {};
};

/// What a step of the tracker did; sums over its parts, see TopologyOptions::longest_motion.
struct TrackerStep {
  MoveResult move;  ///< its fraction is the mean of the parts'
  TopologyStatistics topology;
  RemeshStatistics remesh;
  double move_seconds = 0, topology_seconds = 0, remesh_seconds = 0;  ///< wall time
  /// Area of the films (L²) that the move has made besides what was predicted, topology, and remeshing.
  double move_area = 0, topology_area = 0, remesh_area = 0;
  int parts = 1;
};

/// Whether a vertex still follows what a step has predicted for it, asked after operations have changed what is around
/// it.
using FollowsMotion = std::function<bool(Vertex)>;

/// What a step of the tracker is made of.
enum class TrackerStage { move, topology, remesh };

/// Told, with the surface as it is then, that a stage has been done.
using AfterStage = std::function<void(TrackerStage)>;

/// Moves a labelled surface to where a simulation predicts it to be without letting it intersect itself, and keeps its
/// triangles well shaped: the one class that a simulation talks to.
class SurfaceTracker {
 public:
  /// Throws InputError for options, positions or edges out of range (see mesh/length_range.h).
  explicit SurfaceTracker(SurfaceMesh mesh, const TrackerOptions& options = {});

  /// All that a tracker carries from step to step: the mesh, and with it all named attributes, what is held and solid
  /// among them.
  using State = SurfaceMesh::State;
  State state() const { return mesh_.state(); }
  /// The same as `state`, into one that is there, whose memory is used again.
  void save(State& state) const { mesh_.save(state); }
  /// Puts the surface and all named attributes back, see SurfaceMesh::restore.
  void restore(const State& state) { mesh_.restore(state); }

  const SurfaceMesh& mesh() const { return mesh_; }
  /// For data that is attached to the mesh (attributes).
  SurfaceMesh& mesh() { return mesh_; }
  const TrackerOptions& options() const { return options_; }

  /// What of a vertex is moved by its prediction only, never by collisions or remeshing: all of it, or some of its
  /// coordinates (see mesh/hold.h), as on a wall along which the surface slides. Handed on to new vertices. The mesh's
  /// attribute "hold".
  VertexAttribute<Hold>& held() { return held_; }
  const VertexAttribute<Hold>& held() const { return held_; }
  /// Which triangles are part of a solid, not of a film: not zero for these. The tracker treats both alike; it is for
  /// those who compute with films. Handed on from parent to child. The mesh's attribute "solid".
  TriangleAttribute<std::uint8_t>& solid() { return solid_; }
  const TriangleAttribute<std::uint8_t>& solid() const { return solid_; }

  /// `observer` is told of every operation of `remesh` and `change_topology` for as long as the token lives.
  [[nodiscard]] ObserverToken add_observer(OperationObserver& observer) { return observers_.add(observer); }

  /// One step: moves the vertices to, or near, `predicted` (as `advance` does, and throws what it throws), changes the
  /// topology where that is asked for, and remeshes. A motion in which surfaces collide and that is long (see
  /// TopologyOptions::longest_motion) is done in equal parts with topology and remeshing after each, and is carried
  /// along by the vertices through these operations; those that do not follow it any more (`follows`; empty: all do)
  /// stay for the rest of the step. When a part throws, the surface is as the operations before have left it: whole,
  /// and somewhere within the step (see `state`). `after`, where there is one, is called after every stage of every
  /// part, and must not change the surface.
  TrackerStep step(std::span<const Vec3> predicted, const FollowsMotion& follows = {}, const AfterStage& after = {});

  /// Moves every living vertex in a straight line to, or near, its entry of `predicted` (L, indexed by vertex handle,
  /// one per slot). Throws MotionError, with the mesh as it was, when a prediction is not finite or too far
  /// away, or no motion without intersection is found.
  MoveResult advance(std::span<const Vec3> predicted);

  /// Splits, collapses, flips and smooths towards the resolution, then closes gaps in the numbering when there are
  /// many.
  RemeshStatistics remesh();

  /// One topology pass: joins surfaces that are close, merges very short edges, lets small regions vanish, and
  /// separates vertices where regions meet without a common film. Does nothing when it is not enabled.
  TopologyStatistics change_topology();

 private:
  void require_resolved(std::span<const Vec3> predicted) const;
  MoveResult move_to(std::span<const Vec3> predicted);
  MoveOptions move_options() const;
  double note_motion(std::span<const Vec3> predicted);
  int parts_of(std::span<const Vec3> predicted, TrackerStep& done);
  void move_part(std::span<const Vec3> predicted, TrackerStep& done);
  void improve(TrackerStep& done, const AfterStage& after);

  SurfaceMesh mesh_;
  TrackerOptions options_;
  VertexAttribute<Hold> held_;
  TriangleAttribute<std::uint8_t> solid_;
  NearTriangles near_;  // of no step's result: only what makes the next search faster
  // The displacement that the last step asked of every vertex, L: the attribute "motion". Where the topology may
  // change, or it is to be kept.
  std::optional<VertexAttribute<Vec3>> motion_;
  ObserverList observers_;
};

}  // namespace lostopos
