#pragma once

#include <array>
#include <optional>
#include <span>

#include "LosTopos/geometry/ccd.h"
#include "tests/support/exact_contact.h"

namespace lostopos::test {

// Exact answers to the questions of LosTopos/geometry/ccd.h, in integer arithmetic and by another way: the shapes are
// coplanar at the roots of a cubic with integer coefficients; the roots are isolated by Descartes' rule of signs, and
// at each the containment is decided by the signs of polynomials at that algebraic number. When the cubic vanishes
// identically, the first contact is at the start or at a time when a vertex comes to lie on an edge, and those times
// are the roots looked at. Any finite coordinates. What can be proven in ball arithmetic (ccd_filter.h) needs no
// integers.

struct OracleOptions {
  unsigned bits = 0;                        ///< the interval of the time is refined to 2^-bits
  std::span<const double> apart_from = {};  ///< times in [0, 1] that may be ends of the interval but not inside of it
  bool filter = true;                       ///< ball arithmetic first: the same answers, ten times as fast
};

/// First contact of points[0] with the triangle of the others.
std::optional<ExactContact> exact_vertex_triangle(const std::array<Trajectory, 4>& points,
                                                  const OracleOptions& options = {});

/// First contact of the edge points[0], points[1] with the edge points[2], points[3].
std::optional<ExactContact> exact_edge_edge(const std::array<Trajectory, 4>& points, const OracleOptions& options = {});

}  // namespace lostopos::test
