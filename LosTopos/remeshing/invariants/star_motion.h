#pragma once

#include <array>
#include <span>
#include <vector>

#include "LosTopos/collision/broad_phase.h"
#include "LosTopos/geometry/ccd.h"
#include "LosTopos/remeshing/change_plan.h"

namespace lostopos {

/// A vertex on its way; most stand still.
struct MovingPoint {
  Vertex vertex;
  Trajectory path;
  bool moves;
};

/// The parts of the surface that change when one vertex, or the two ends of an edge, move in a straight line: all
/// vertices, edges and triangles that have a point that moves, each once.
class StarMotion {
 public:
  using Points = std::array<MovingPoint, 3>;
  struct MovingEdge {
    std::array<MovingPoint, 2> ends;
    Box box;
  };
  struct MovingTriangle {
    Points corners;
    Box box;
  };

  void clear();
  /// The planned triangles at `vertex`, which moves from where it is in the plan to `target` (perhaps the same place).
  void add_planned_star(const ChangePlan& plan, Vertex vertex, const Vec3& target);
  /// A triangle of which one or two corners move.
  void add(const Points& corners);

  std::span<const MovingPoint> points() const { return points_; }
  std::span<const MovingEdge> edges() const { return edges_; }
  std::span<const MovingTriangle> triangles() const { return triangles_; }
  /// Everything, all the way.
  const Box& box() const { return box_; }

 private:
  void add_point(const MovingPoint& point);
  void add_edge(const MovingPoint& a, const MovingPoint& b);

  std::vector<MovingPoint> points_;
  std::vector<MovingEdge> edges_;
  std::vector<MovingTriangle> triangles_;
  Box box_;
};

}  // namespace lostopos
