#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "LosTopos/remeshing/remesh_context.h"
#include "LosTopos/topology/sectors.h"
#include "LosTopos/topology/topology_options.h"

namespace lostopos {

/// Parts a vertex in two: T1 by vertex separation (Da, Batty, Grinspun 2014, section 4.2), and the end of a contact at
/// a point. Of two sectors A and B at the vertex that have no film between them, a copy of the vertex keeps the
/// triangles of A and moves along d, from the mean of B's link to that of A's; the vertex keeps all others and moves
/// the other way. At each edge where A and others meet, the copy and the vertex span a new film between the regions to
/// either side of it, unless these are the same. Of all pairs at the vertex the one that gains most is taken.
class VertexSeparation {
 public:
  /// Displacement that the last step asked of a vertex, L; for the rule `flow`.
  using Flow = std::function<Vec3(Vertex)>;

  /// `pull_apart`: the distance between the two afterwards, L. `flow` may be empty with the rule `area`.
  VertexSeparation(RemeshContext& context, SeparationRule rule, double pull_apart, Flow flow)
      : c_(context), rule_(rule), pull_apart_(pull_apart), flow_(std::move(flow)) {}

  /// Separates v, or says why not and leaves the mesh as it was. `v` must not be complete (see is_complete).
  std::optional<Refusal> attempt(Vertex v);

  /// Of the last separation: the new vertex, the regions that lost contact and between which films are new.
  Vertex added() const { return added_; }
  const std::vector<Region>& regions() const { return regions_; }

 private:
  // A long list moves its memory, a short one its elements, which do not throw.
  // NOLINTNEXTLINE(bugprone-exception-escape)
  struct Candidate {
    SurfaceMesh::TriangleList leaving;  ///< the triangles that the copy takes
    Region leaving_region, other_region;
    Vec3 direction;
    double gain;
  };

  void list_candidates(Vertex v);
  void consider(Vertex v, const SurfaceMesh::TriangleList& leaving, const SurfaceMesh::TriangleList& other,
                Region leaving_region, Region other_region);
  std::optional<Refusal> plan(Vertex v, const Candidate& candidate, double distance);
  std::optional<Refusal> plan_new_film(Vertex v, Edge e, const Candidate& candidate);
  std::optional<Refusal> check_plan(Vertex v, const Candidate& candidate, double distance);
  void carry_out(Vertex v);

  RemeshContext& c_;
  SeparationRule rule_;
  double pull_apart_;
  Flow flow_;
  std::vector<Candidate> candidates_;
  Vec3 leaving_position_ = Vec3::Zero(), staying_position_ = Vec3::Zero();
  Vertex added_;
  std::vector<Region> regions_;
};

}  // namespace lostopos
