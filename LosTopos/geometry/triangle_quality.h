#pragma once

#include "LosTopos/vec3.h"

namespace lostopos {

// Shape of triangles. Angles are in radians and come from atan2 of a cross and a dot product, which keeps them
// accurate near 0 and pi; no function divides by an area. Collapsed triangles are allowed unless said otherwise.

/// Area of abc, not negative.
double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// Unit normal of abc, right-handed; zero when the triangle is collapsed.
Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// The angle at `corner` between the directions to p and q, in [0, pi]; 0 when one of them is at the corner.
double corner_angle(const Vec3& corner, const Vec3& p, const Vec3& q);

/// The angles at a, b and c.
Vec3 triangle_angles(const Vec3& a, const Vec3& b, const Vec3& c);

/// The smallest and the largest of the three angles.
double min_angle(const Vec3& a, const Vec3& b, const Vec3& c);
double max_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Longest edge over shortest altitude, times sqrt(3)/2: 1 for an equilateral triangle, larger for any other,
/// infinite for a collapsed one.
double aspect_ratio(const Vec3& a, const Vec3& b, const Vec3& c);

/// The angle, in (-pi, pi], by which the half plane of the triangle (e0, e1, a) turns right-handedly about the
/// direction e0 -> e1 to reach that of (e0, e1, b): 0 when they are folded onto each other, +-pi when they are flat.
/// Swapping a and b, or e0 and e1, changes the sign. 0 when a triangle is collapsed.
double dihedral_angle(const Vec3& e0, const Vec3& e1, const Vec3& a, const Vec3& b);

}  // namespace lostopos
