#pragma once

#include <array>
#include <optional>

#include "LosTopos/geometry/ccd.h"

namespace lostopos::test {

/// An interval that holds the exact time of the first contact.
struct ExactContact {
  double low = 0;
  double high = 0;
};

// Exact answers to the questions of LosTopos/geometry/ccd.h, in integer arithmetic and by another way: the shapes are
// coplanar at the roots of a cubic with integer coefficients; the roots are isolated by Sturm's theorem, and at each
// the containment is decided by the signs of polynomials at that algebraic number. When the cubic vanishes identically,
// the first contact is at the start or at a time when a vertex comes to lie on an edge, and those times are the roots
// looked at. Any finite coordinates.

/// First contact of points[0] with the triangle of the others. `bits`: the interval is refined to 2^-bits.
std::optional<ExactContact> exact_vertex_triangle(const std::array<Trajectory, 4>& points, unsigned bits = 0);

/// First contact of the edge points[0], points[1] with the edge points[2], points[3].
std::optional<ExactContact> exact_edge_edge(const std::array<Trajectory, 4>& points, unsigned bits = 0);

}  // namespace lostopos::test
