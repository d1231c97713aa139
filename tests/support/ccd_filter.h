#pragma once

#include <array>
#include <optional>
#include <span>

#include "LosTopos/geometry/ccd.h"
#include "tests/support/exact_contact.h"

namespace lostopos::test {

// Proofs in ball arithmetic that two moving shapes do not meet, or first meet between two times. [0, 1] is cut into
// pieces. There is no contact in a piece when a coordinate of all differences has one sign, when the coplanarity cubic
// has, or when a polynomial that has to be positive or zero where the shapes touch is negative. There is one when the
// cubic has just one root in it and all those polynomials are positive about that root. Whatever rounding leaves open
// is undecided: contacts at the start, at corners and borders, and shapes in one plane or on one line.

/// What the filter has proven.
struct FilteredContact {
  bool decided = false;
  std::optional<ExactContact> contact;  ///< when decided
};

/// Of points[0] with the triangle of the others. Arguments as in ccd_oracle.h.
FilteredContact filter_vertex_triangle(const std::array<Trajectory, 4>& points, unsigned bits,
                                       std::span<const double> apart_from);

/// Of the edge points[0], points[1] with the edge points[2], points[3].
FilteredContact filter_edge_edge(const std::array<Trajectory, 4>& points, unsigned bits,
                                 std::span<const double> apart_from);

}  // namespace lostopos::test
