#pragma once

#include <array>
#include <span>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/vec3.h"

namespace lostopos {

class SurfaceMesh;

/// A triangle that an operation made and the one it takes the place of. In the `after_` events the parent is gone, but
/// its slot is not in use again yet: attribute[parent] still holds its value, so that attribute[child] =
/// attribute[parent] hands it on.
struct TriangleSource {
  Triangle child, parent;
};

/// Edge (ends[0], ends[1]) gets a vertex between its ends. Per-vertex data: the mean of the two ends (docs/method.md
/// "Carrying data"), wherever the new vertex lies.
struct SplitEvent {
  Edge edge;                                  ///< gone in the after-event
  std::array<Vertex, 2> ends;                 ///< they stay
  Vertex added;                               ///< invalid in the before-event
  Vec3 position;                              ///< of the new vertex, L
  std::span<const TriangleSource> triangles;  ///< empty in the before-event
};

/// `removed` merges into `kept`.
struct CollapseEvent {
  Edge edge;  ///< gone in the after-event
  Vertex kept, removed;
  double t;       ///< where the result lies between kept (0) and removed (1): data = (1 − t) kept + t removed
  Vec3 position;  ///< of the result, L; may be off the edge's line by the shift that keeps the volumes
  std::span<const TriangleSource> triangles;  ///< empty in the before-event
};

/// The edge between the two triangles (old_ends, new_ends[i]) is turned to join new_ends.
struct FlipEvent {
  Edge edge;   ///< gone in the after-event
  Edge added;  ///< invalid in the before-event
  std::array<Vertex, 2> old_ends, new_ends;
  Vertex moved;                               ///< one of new_ends, which the flip moves to keep the volumes; or invalid
  Vec3 position;                              ///< of that vertex afterwards, L
  std::span<const TriangleSource> triangles;  ///< empty in the before-event
};

/// Smoothing moved a vertex; nothing else changes.
struct MoveEvent {
  Vertex vertex;
  Vec3 from, to;  ///< L
};

/// A point of the surface: at a vertex, on an edge or in a triangle, as a mean of one, two or three vertices.
struct Place {
  std::array<Vertex, 3> vertices;      ///< the first `count` are used
  std::array<double, 3> weights = {};  ///< not negative, sum 1
  std::size_t count = 0;
};

/// Two places become one vertex (snapping, or the end of a very short edge), and triangles that coincide by it cancel.
/// Per-vertex data: (1 − t) of the first place plus t of the second, each the mean of its vertices by their weights.
struct MergeEvent {
  std::array<Place, 2> places;
  double t;                         ///< where the result lies between the two
  Vertex result;                    ///< a vertex of a place, or a new one (then invalid in the before-event)
  Vec3 position;                    ///< of the result, L
  std::span<const Vertex> removed;  ///< gone in the after-event; the result among them when nothing is left
  std::span<const TriangleSource>
      triangles;  ///< empty in the before-event; labels of a child may differ from its parent
};

/// A vertex parts in two; both copies keep its data. New films may stand between the two.
struct SeparationEvent {
  Vertex vertex;                              ///< stays with a part of its triangles
  Vertex added;                               ///< gets the others; invalid in the before-event
  Vec3 position, added_position;              ///< afterwards, L
  std::span<const TriangleSource> triangles;  ///< empty in the before-event; of a new film the parent is a neighbour
};

/// Is told of every operation that is done (never of one that is refused): `before_` with the mesh still as it was,
/// then `after_` with the operation complete. Handles that the event calls gone may be read from attributes in the
/// after-event (their slots are not in use again yet), but not from the mesh. An observer must not change the mesh.
/// Named attributes are carried by then: in a `before_` they are untouched, in an `after_` what the operation makes of
/// them.
class OperationObserver {
 public:
  OperationObserver() = default;
  OperationObserver(const OperationObserver&) = delete;
  OperationObserver& operator=(const OperationObserver&) = delete;
  virtual ~OperationObserver() = default;

  virtual void before_split(const SurfaceMesh&, const SplitEvent&) {}
  virtual void after_split(const SurfaceMesh&, const SplitEvent&) {}
  virtual void before_collapse(const SurfaceMesh&, const CollapseEvent&) {}
  virtual void after_collapse(const SurfaceMesh&, const CollapseEvent&) {}
  virtual void before_flip(const SurfaceMesh&, const FlipEvent&) {}
  virtual void after_flip(const SurfaceMesh&, const FlipEvent&) {}
  virtual void before_move(const SurfaceMesh&, const MoveEvent&) {}
  virtual void after_move(const SurfaceMesh&, const MoveEvent&) {}
  virtual void before_merge(const SurfaceMesh&, const MergeEvent&) {}
  virtual void after_merge(const SurfaceMesh&, const MergeEvent&) {}
  virtual void before_separation(const SurfaceMesh&, const SeparationEvent&) {}
  virtual void after_separation(const SurfaceMesh&, const SeparationEvent&) {}
};

}  // namespace lostopos
