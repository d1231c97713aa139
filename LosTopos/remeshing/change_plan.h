#pragma once

#include <array>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Stands for the vertex that an operation will add, until it is there.
inline constexpr Vertex planned_vertex{Vertex::invalid_index - 1};
/// Stands for a second point that moves together with it and never becomes a vertex.
inline constexpr Vertex second_planned_vertex{Vertex::invalid_index - 2};

using Corners = std::array<Vec3, 3>;

/// The worst of a number of triangles. Angles in radians, other measures in L and L².
struct ShapeSummary {
  double min_angle, max_angle, min_area, longest_edge;
  static ShapeSummary of_none();
  void add(const Corners& corners);
};

/// A triangle as it will be.
struct PlannedTriangle {
  std::array<Vertex, 3> vertices;  ///< one of them may be `planned_vertex`
  Corners corners;
  Labels labels;
  Triangle parent;  ///< the one whose place it takes
  Vec3 old_normal;  ///< which way the surface looked here, any length
  bool moved_only;  ///< the parent itself, with a corner moved
};

/// The result of an operation, computed beside the mesh: the triangles it touches, and what will be there instead. All
/// checks look at plans; the mesh is changed when every one has passed, so that nothing ever has to be undone. Kept and
/// reused from one operation to the next, so that none allocates.
struct ChangePlan {
  std::vector<Triangle> replaced;
  std::vector<PlannedTriangle> triangles;
  ShapeSummary before, after;
  double volume_change = 0;  ///< the largest of a region, L³

  void clear();
  /// Adds t, with its corner `from` replaced by `to` at `position`. `moved_only` when from == to.
  void add_moved(const SurfaceMesh& mesh, Triangle t, Vertex from, Vertex to, const Vec3& position);
  /// Puts the planned triangles' corners at `vertex` to `position`.
  void move(Vertex vertex, const Vec3& position);
  /// Fills in before, after and volume_change.
  void measure(const SurfaceMesh& mesh);
  /// Of that, volume_change alone.
  void measure_volumes(const SurfaceMesh& mesh);
};

}  // namespace lostopos
