#pragma once

#include <Eigen/Core>
#include <array>

#include "LosTopos/vec3.h"

namespace lostopos {

// Exact predicates on points with double coordinates. Every answer is that of exact arithmetic for all finite inputs,
// denormal and huge ones included: a floating-point filter decides the easy cases (error bounds as in Shewchuk 1997,
// "Adaptive precision floating-point arithmetic and fast robust geometric predicates", with a term for underflow
// added), integer arithmetic the others. No tolerance is involved. NaN and infinite coordinates are not allowed.

using Vec2 = Eigen::Vector2d;

/// How two closed sets meet.
enum class Crossing {
  none,      ///< they have no common point
  proper,    ///< they cross in general position: the answer survives a small enough change of the points
  touching,  ///< they have a common point, but a boundary or a degenerate or coplanar position is involved
};

/// Sign of (b - a) x (c - a): 1 when a, b, c turn to the left, -1 to the right, 0 when they are on a line.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of ((b - a) x (c - a)) . (d - a): 1 when d is on the side that the right-handed normal of a, b, c points to,
/// -1 on the other side, 0 when the four points are coplanar.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether a, b, c are on one line (or coincide).
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether the closed segments p0p1 and q0q1 have a common point. Segments in space meet in degenerate position only.
bool segments_intersect(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

/// How the closed segment s0s1 meets the closed triangle t0t1t2. proper: the segment's interior crosses the
/// triangle's interior. Collapsed segments and triangles are treated as the points or segments that they are.
Crossing segment_triangle_intersect(const Vec3& s0, const Vec3& s1, const Vec3& t0, const Vec3& t1, const Vec3& t2);

/// How two closed triangles that share no vertex meet. proper: an edge of one properly crosses the other.
Crossing triangles_intersect(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// How the triangles (shared, a1, a2) and (shared, b1, b2) meet away from their common vertex: two convex sets with a
/// common corner that meet elsewhere do so on the edge opposite to that corner of one of them.
/// A triangle collapsed to a segment with `shared` in its middle always counts as touching.
Crossing triangles_intersect_sharing_vertex(const Vec3& shared, const Vec3& a1, const Vec3& a2, const Vec3& b1,
                                            const Vec3& b2);

/// Whether the triangles (e0, e1, a) and (e0, e1, b) have a common point off their common edge e0e1, which they have
/// exactly when they are coplanar and folded onto each other.
bool coplanar_overlap_sharing_edge(const Vec3& e0, const Vec3& e1, const Vec3& a, const Vec3& b);

}  // namespace lostopos
