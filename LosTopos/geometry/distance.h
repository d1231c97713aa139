#pragma once

#include "LosTopos/vec3.h"

namespace lostopos {

// Closest points, accurate at any scale and for collapsed inputs (segments of zero length, triangles that are slivers,
// segments or points). Every answer belongs to a point of the closed shape: the weights are feasible to the last bit,
// and the distance is the length of the returned offset, so that it exceeds the true one by rounding alone (a few
// units in the last place of the coordinates' differences). Coordinates must be finite.

struct PointSegmentDistance {
  double distance = 0;         ///< length of offset
  double t = 0;                ///< the closest point is a + t (b - a), in [0, 1]
  Vec3 offset = Vec3::Zero();  ///< from the closest point of the segment to the point
};

struct PointTriangleDistance {
  double distance = 0;           ///< length of offset
  Vec3 weights = Vec3::UnitX();  ///< of a, b, c in the closest point; not negative, sum 1
  Vec3 offset = Vec3::Zero();    ///< from the closest point of the triangle to the point
};

struct SegmentSegmentDistance {
  double distance = 0;         ///< length of offset
  double s = 0;                ///< the closest point of the first is p0 + s (p1 - p0), in [0, 1]
  double t = 0;                ///< the closest point of the second is q0 + t (q1 - q0), in [0, 1]
  Vec3 offset = Vec3::Zero();  ///< from the closest point of the second to that of the first
};

/// Point p against the segment ab. A segment of zero length answers with t = 0.
PointSegmentDistance point_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b);

/// Point p against the triangle abc.
PointTriangleDistance point_triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Segment p0p1 against segment q0q1. Of parallel segments one of the equally close pairs is given.
SegmentSegmentDistance segment_segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

}  // namespace lostopos
