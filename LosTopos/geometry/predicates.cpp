// Intersection predicates, built from the signs of the orientation predicates and comparisons of coordinates alone.
#include "LosTopos/geometry/predicates.h"

#include <algorithm>

namespace lostopos {
namespace {

using Triple = std::array<const Vec3*, 3>;

// The point without its coordinate `axis`.
Vec2 dropped(const Vec3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

int orient_dropped(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  return orient2d(dropped(a, axis), dropped(b, axis), dropped(c, axis));
}

// An axis along which the plane of a, b, c projects one to one, or -1 when they are collinear.
int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orient_dropped(a, b, c, axis) != 0) return axis;
  }
  return -1;
}

bool lexicographic_less(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

struct Box {
  Vec3 low;
  Vec3 high;
};

Box box_of(const Vec3& a, const Vec3& b) {
  return {a.cwiseMin(b), a.cwiseMax(b)};
}
Box box_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

bool disjoint(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return true;
  }
  return false;
}

// Segments on one line: their intervals in lexicographic order, which is monotone along any line.
bool collinear_segments_intersect(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const auto [p_low, p_high] = std::minmax(p0, p1, lexicographic_less);
  const auto [q_low, q_high] = std::minmax(q0, q1, lexicographic_less);
  return !lexicographic_less(p_high, q_low) && !lexicographic_less(q_high, p_low);
}

// Segments in one plane, not all on one line, that projects one to one along the axis.
bool planar_segments_intersect(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, int axis) {
  const int q0_side = orient_dropped(p0, p1, q0, axis);
  const int q1_side = orient_dropped(p0, p1, q1, axis);
  if (q0_side * q1_side > 0) return false;
  const int p0_side = orient_dropped(q0, q1, p0, axis);
  const int p1_side = orient_dropped(q0, q1, p1, axis);
  if (p0_side * p1_side > 0) return false;
  if (q0_side == 0 && q1_side == 0 && p0_side == 0 && p1_side == 0) {
    return collinear_segments_intersect(p0, p1, q0, q1);
  }
  return true;
}

// A point of the triangle's plane against the triangle, which projects along the axis without collapsing.
bool point_in_planar_triangle(const Vec3& p, const Triple& t, int axis) {
  const int s0 = orient_dropped(*t[0], *t[1], p, axis);
  const int s1 = orient_dropped(*t[1], *t[2], p, axis);
  const int s2 = orient_dropped(*t[2], *t[0], p, axis);
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

Crossing touching_if(bool condition) {
  return condition ? Crossing::touching : Crossing::none;
}

// Segment in the plane of a triangle, or a triangle that is collapsed to a segment or point.
Crossing coplanar_contact(const Vec3& s0, const Vec3& s1, const Triple& t) {
  const int axis = projection_axis(*t[0], *t[1], *t[2]);
  if (axis < 0) {
    return touching_if(segments_intersect(s0, s1, *t[0], *t[1]) || segments_intersect(s0, s1, *t[1], *t[2]) ||
                       segments_intersect(s0, s1, *t[2], *t[0]));
  }
  return touching_if(point_in_planar_triangle(s0, t, axis) || planar_segments_intersect(s0, s1, *t[0], *t[1], axis) ||
                     planar_segments_intersect(s0, s1, *t[1], *t[2], axis) ||
                     planar_segments_intersect(s0, s1, *t[2], *t[0], axis));
}

// The stronger of two answers: proper, touching, none.
Crossing stronger(Crossing a, Crossing b) {
  if (a == Crossing::proper || b == Crossing::proper) return Crossing::proper;
  return touching_if(a == Crossing::touching || b == Crossing::touching);
}

Crossing edges_against_triangle(const std::array<Vec3, 3>& edges, const std::array<Vec3, 3>& t) {
  Crossing contact = Crossing::none;
  for (std::size_t i = 0; i < 3 && contact != Crossing::proper; ++i) {
    contact = stronger(contact, segment_triangle_intersect(edges[i], edges[(i + 1) % 3], t[0], t[1], t[2]));
  }
  return contact;
}

bool strictly_on_one_side(const std::array<Vec3, 3>& points, const std::array<Vec3, 3>& t) {
  const int side = orient3d(t[0], t[1], t[2], points[0]);
  return side != 0 && orient3d(t[0], t[1], t[2], points[1]) == side && orient3d(t[0], t[1], t[2], points[2]) == side;
}

}  // namespace

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return projection_axis(a, b, c) < 0;
}

bool segments_intersect(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  if (disjoint(box_of(p0, p1), box_of(q0, q1))) return false;
  if (orient3d(p0, p1, q0, q1) != 0) return false;
  int axis = projection_axis(p0, p1, q0);
  if (axis < 0) axis = projection_axis(p0, p1, q1);
  if (axis < 0) axis = projection_axis(q0, q1, p0);
  if (axis < 0) axis = projection_axis(q0, q1, p1);
  if (axis < 0) return collinear_segments_intersect(p0, p1, q0, q1);
  return planar_segments_intersect(p0, p1, q0, q1, axis);
}

Crossing segment_triangle_intersect(const Vec3& s0, const Vec3& s1, const Vec3& t0, const Vec3& t1, const Vec3& t2) {
  if (disjoint(box_of(s0, s1), box_of(t0, t1, t2))) return Crossing::none;
  const int side0 = orient3d(t0, t1, t2, s0);
  const int side1 = orient3d(t0, t1, t2, s1);
  if (side0 * side1 > 0) return Crossing::none;
  if (side0 == 0 && side1 == 0) return coplanar_contact(s0, s1, {&t0, &t1, &t2});

  // The segment's line meets the plane in one point; the signs say on which side of each edge.
  const int edge0 = orient3d(s0, s1, t0, t1);
  const int edge1 = orient3d(s0, s1, t1, t2);
  const int edge2 = orient3d(s0, s1, t2, t0);
  const bool inside = (edge0 >= 0 && edge1 >= 0 && edge2 >= 0) || (edge0 <= 0 && edge1 <= 0 && edge2 <= 0);
  if (!inside) return Crossing::none;
  const bool general = side0 * side1 * edge0 * edge1 * edge2 != 0;
  return general ? Crossing::proper : Crossing::touching;
}

Crossing triangles_intersect(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  if (disjoint(box_of(a[0], a[1], a[2]), box_of(b[0], b[1], b[2]))) return Crossing::none;
  if (strictly_on_one_side(a, b) || strictly_on_one_side(b, a)) return Crossing::none;
  const Crossing contact = edges_against_triangle(a, b);
  return contact == Crossing::proper ? contact : stronger(contact, edges_against_triangle(b, a));
}

Crossing triangles_intersect_sharing_vertex(const Vec3& shared, const Vec3& a1, const Vec3& a2, const Vec3& b1,
                                            const Vec3& b2) {
  return stronger(segment_triangle_intersect(a1, a2, shared, b1, b2),
                  segment_triangle_intersect(b1, b2, shared, a1, a2));
}

bool coplanar_overlap_sharing_edge(const Vec3& e0, const Vec3& e1, const Vec3& a, const Vec3& b) {
  if (orient3d(e0, e1, a, b) != 0) return false;
  const int axis = projection_axis(e0, e1, a);
  if (axis >= 0) return orient_dropped(e0, e1, a, axis) == orient_dropped(e0, e1, b, axis);

  // a is on the edge's line, or the edge is a point.
  if (!collinear(e0, e1, b) || !collinear(e0, a, b)) return false;
  const auto [low, high] = std::minmax(e0, e1, lexicographic_less);
  const bool past_high = lexicographic_less(high, a) && lexicographic_less(high, b);
  const bool past_low = lexicographic_less(a, low) && lexicographic_less(b, low);
  return past_high || past_low;
}

}  // namespace lostopos
