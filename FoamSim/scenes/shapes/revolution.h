#pragma once

#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// @name Parts of surfaces of revolution
/// about the x or the y axis. `along` is the coordinate on the axis (L).
///@{
using Ring = std::vector<lostopos::Vertex>;
enum class Axis { x, y };

lostopos::Vertex add_point(lostopos::SurfaceMesh& mesh, double along, Axis axis = Axis::x);
/// `count` vertices, vertex k at the angle 2πk/count: (along, r cos, r sin) about x, (r cos, along, −r sin) about y.
Ring add_ring(lostopos::SurfaceMesh& mesh, long count, double along, double radius, Axis axis = Axis::x);
/// Triangles from a centre to a ring, right-hand normals towards the axis' positive end; `labels` (behind, in front) is
/// for that direction.
void add_fan(lostopos::SurfaceMesh& mesh, lostopos::Vertex centre, const Ring& ring, lostopos::Labels labels);
/// A belt between two rings of as many vertices, `low` at the smaller coordinate, normals away from the axis.
void add_belt(lostopos::SurfaceMesh& mesh, const Ring& low, const Ring& high, lostopos::Labels labels);
///@}

/// A part of a sphere of revolution about x, from its pole to the circle where it overlaps its mirror image.
struct CapShape {
  long rings;         ///< N: rings of the whole sphere from pole to pole
  long overlap;       ///< o, rings that lie beyond the circle; the centre is at ±radius cos(π o/N)
  int side;           ///< −1: towards −x, +1: towards +x
  double radius = 1;  ///< L
  double taper = 0;  ///< ring i is nearer to the centre by the factor 1 − taper (1 − i/(N − o)), the pole by 1 − taper
};
/// Its rings from the pole outwards: entry i − 1 has the polar angle π i/N; the last is `circle`.
std::vector<Ring> add_cap(lostopos::SurfaceMesh& mesh, const CapShape& shape, const Ring& circle,
                          lostopos::Region inside);
/// Radius of the circle where such caps end.
double circle_radius(const CapShape& shape);

}  // namespace foamsim
