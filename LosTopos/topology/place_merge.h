#pragma once

#include <optional>
#include <vector>

#include "LosTopos/remeshing/remesh_context.h"
#include "LosTopos/topology/site.h"

namespace lostopos {

/// Makes two places of the surface one vertex and cancels the triangles that coincide then: snapping (docs/method.md
/// "Topology"). What lies on an edge or in a triangle is split there; a pair of vertices that an edge joins loses its
/// triangles. The result lies on the straight line between the two, at the one that is bound more (held, then corner,
/// border, film) or in the middle. All of it is one operation: when any part is refused, nothing is done.
///
/// That two stars which move towards each other along the line between their centres do not cross on the way: for
/// elements (a, x) and (b, y) of the two, the volume of (a, x, b, y) is |ab| times a factor that does not depend on
/// where on the line a and b are, so its sign does not change before they meet. Everything else is checked as motion
/// against what stands still.
class PlaceMerge {
 public:
  explicit PlaceMerge(RemeshContext& context) : c_(context) {}

  struct Rules {
    bool joined_vertices = false;   ///< two vertices that an edge joins may be merged
    bool keeps_orientation = true;  ///< refuse to turn triangles by a right angle or more
    /// Where the stars of the two places have a vertex in common: how much of the unit vector `direction`, from one
    /// surface to the other, has to be normal to the films at both (see transversality).
    double min_transversality = 0;
    Vec3 direction = Vec3::Zero();
  };

  /// Merges, or says why not and leaves the mesh as it was.
  std::optional<Refusal> attempt(const Site& a, const Site& b, const Rules& rules);

  /// Of the last merge: the vertex it left (invalid when nothing is left there), where, the triangles that cancelled.
  Vertex result() const { return result_; }
  const Vec3& position() const { return position_; }
  std::size_t cancelled() const { return cancelled_; }

 private:
  std::optional<Refusal> check(const Rules& rules);
  std::optional<Refusal> choose_position();
  std::optional<Refusal> require_apart(const Rules& rules) const;
  void plan_star(const Site& site);
  bool keeps_open_edges() const;
  void plan_motion();
  void carry_out();

  RemeshContext& c_;
  std::array<Site, 2> sites_;
  std::array<SurfaceMesh::TriangleList, 2> stars_;
  Vertex kept_;  // planned_vertex: a new one
  double t_ = 0;
  Vec3 position_ = Vec3::Zero();
  Vertex result_;
  std::size_t cancelled_ = 0;
  std::vector<Vertex> touched_, removed_;
};

}  // namespace lostopos
