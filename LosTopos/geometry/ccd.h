#pragma once

#include <array>
#include <optional>

#include "LosTopos/vec3.h"

namespace lostopos {

// Continuous collision detection of points that move on straight lines at constant speed, x(t) = start + t (end -
// start), t in [0, 1], in exact real arithmetic.
//
// Method: conservative advancement (Mirtich 1996) by separating planes, as in van den Bergen 2004, "Ray casting against
// general convex objects with application to continuous collision detection". Two convex shapes meet exactly when the
// origin is in the hull of the differences of their vertices, 3 or 4 points in linear motion. A plane through the
// origin certifies that they do not for as long as n . difference(t) > 0 for all of them. The advance jumps to the end
// of that stretch, takes the plane of the nearest feature there, and goes on until the end of the motion (no
// collision) or until nothing is certified any more (collision). n may be fixed (linear functions of time), turn with
// an edge (quadratics), or be the normal that turns with the face, which leaves the sign of the coplanarity cubic; the
// latter two go by their Bernstein coefficients (Tang et al. 2014, "Fast and exact continuous collision detection with
// Bernstein sign classification").
//
// Guarantees, for finite coordinates:
//  - No collision is missed. Every certificate has forward bounds of all rounding errors and underflows taken off, so
//    that "no collision" is a proof; in doubt the answer is a collision.
//  - The time given is never later than the first exact contact: [0, time) is free of contact.
//  - A false collision needs shapes that come as near as about 1e-12 of the largest difference between coordinates of
//    the two shapes at the same time (so positions far from the origin and common translations do not matter);
//    or, next to a multiple collapse, about 1e-8, when the advance has used up its max_advances steps.
//  - The answer is the same, to the last bit, for any order of a triangle's vertices, of an edge's ends, and of the two
//    edges: arguments are sorted first.
// No allocation. Typically some 30 ns when an axis separates, 100 ns for a near miss, 1.5 us for a hit.

/// Steps after which an advance gives up and reports a collision at the time it has reached.
inline constexpr int max_advances = 128;

/// Straight motion of a point over the step.
struct Trajectory {
  Vec3 start;
  Vec3 end;
};

/// First contact of two moving shapes.
struct Collision {
  /// In [0, 1]; 0 when the shapes are in contact at the start.
  double time = 0;

  /// Shares of the four points, in argument order, in the points of contact; not negative. Vertex-triangle: weights[0]
  /// is 1 and the others sum to 1. Edge-edge: the first two sum to 1, and so do the last two.
  std::array<double, 4> weights = {};

  /// Unit normal of a plane that separates the shapes until the contact, best effort from the geometry at that
  /// time; points from the triangle to the vertex, or from the second edge to the first. When they are in contact at
  /// the start it is the normal of the plane of contact, so oriented that relative_displacement is not positive.
  Vec3 normal = Vec3::UnitX();

  /// Normal component of the displacement, over the whole step, of the contact point on the vertex (the first edge)
  /// less that on the triangle (the second edge), in units of length; negative when approaching. It can be positive
  /// when the shapes but graze, within rounding.
  double relative_displacement = 0;
};

/// First contact of the point with the closed triangle abc, or nothing when they do not meet in [0, 1].
std::optional<Collision> vertex_triangle_collision(const Trajectory& point, const Trajectory& a, const Trajectory& b,
                                                   const Trajectory& c);

/// First contact of the closed edge ab with the closed edge cd, or nothing when they do not meet in [0, 1].
std::optional<Collision> edge_edge_collision(const Trajectory& a, const Trajectory& b, const Trajectory& c,
                                             const Trajectory& d);

}  // namespace lostopos
