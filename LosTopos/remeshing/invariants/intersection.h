#pragma once

#include <array>
#include <span>
#include <vector>

#include "LosTopos/remeshing/invariants/star_motion.h"
#include "LosTopos/remeshing/surface_index.h"

namespace lostopos {

/// Decides whether an operation would make the surface touch or pass through itself, or leave a gap so small (a
/// millionth of the region it works on, and smaller than before) that later motion could not be told from contact. The
/// surface is taken to be free of intersections before; then it is afterwards too, without a tolerance.
class IntersectionGuard {
 public:
  IntersectionGuard(const SurfaceMesh& mesh, SurfaceIndex& index) : mesh_(mesh), index_(index) {}

  /// What is not there during a motion, or takes part in it: all elements at these vertices, up to two edges with all
  /// their triangles, and up to two triangles.
  struct LeftOut {
    std::span<const Vertex> vertices;
    Edge edge = {}, second_edge = {};
    std::array<Triangle, 2> triangles = {};
    bool has(Edge e) const { return e == edge || e == second_edge; }
  };
  /// Continuous collision detection of the moving star against everything else near it that stands still, elements
  /// that share a vertex excepted. Every two triangles that meet without having a vertex in common, or that have one or
  /// two and meet elsewhere, include such a pair. False when there is a contact at any time, the end included.
  bool is_free(const StarMotion& motion, const LeftOut& left_out);
  /// The same for `v`, which moves alone and takes its triangles with it: these are what `motion` holds.
  bool move_is_free(Vertex v, const StarMotion& motion);

  /// Whether turning the edge (a, b) of the triangles (a, b, c) and (b, a, d) to (c, d) sweeps over nothing: exact
  /// tests of the tetrahedron between the two states against everything near it.
  bool flip_is_free(Edge e, Vertex c, Vertex d);

 private:
  struct StaticVertex {
    Vertex vertex;
    Trajectory path;
  };
  struct StaticEdge {
    Edge edge;
    std::array<Vertex, 2> ends;
    Box box;
  };
  struct StaticTriangle {
    Triangle triangle;
    Box box;
  };

  void gather(const Box& box, const LeftOut& left_out);
  template <class Brings>
  void sift(const Box& box, const LeftOut& left_out, const Brings& brings);
  bool nothing_is_met(const StarMotion& motion) const;
  bool point_is_free(const MovingPoint& point) const;
  bool edge_is_free(const StarMotion::MovingEdge& edge) const;
  bool triangle_is_free(const StarMotion::MovingTriangle& triangle) const;
  bool new_edge_is_free(Vertex c, Vertex d) const;
  bool new_triangle_is_free(const std::array<Vertex, 3>& triangle) const;
  bool tetrahedron_is_empty(const std::array<Vertex, 4>& corners) const;
  bool is_not_folded(Edge e, const std::array<Vertex, 3>& triangle) const;

  const SurfaceMesh& mesh_;
  SurfaceIndex& index_;
  std::vector<Triangle> found_;
  std::vector<StaticVertex> vertices_;
  std::vector<StaticEdge> edges_;
  std::vector<StaticTriangle> triangles_;
  double least_gap_ = 0;  // L; of the operation being checked
};

}  // namespace lostopos
