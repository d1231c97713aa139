#pragma once

#include <array>
#include <optional>

#include "LosTopos/vec3.h"

namespace lostopos {

// The core of continuous collision detection (see ccd.h for the method): when does the convex hull of 3 or 4 points
// in linear motion first contain the origin?

/// A vector that changes linearly over t in [0, 1].
struct MovingVector {
  Vec3 start;
  Vec3 end;

  Vec3 at(double t) const { return (1 - t) * start + t * end; }
};

/// The differences between the vertices of two shapes, second less first. Each component carries a relative error of at
/// most half an ulp, or an absolute one of two of the smallest denormals. At a contact, corners[0], e1 and e2 are
/// coplanar.
struct MovingHull {
  int size = 0;                         ///< number of corners: 3 vertex-triangle, 4 edge-edge
  std::array<MovingVector, 4> corners;  ///< triangle: a - p, b - p, c - p; edges ab, cd: c - a, d - a, c - b, d - b
  MovingVector e1;                      ///< triangle: b - a; edges: b - a
  MovingVector e2;                      ///< triangle: c - a; edges: d - c
};

/// Whether the signs of the corners' components along one axis prove that the hull never contains the origin. Exact,
/// and the same for any order of the corners.
bool separated_along_an_axis(const MovingHull& hull);

/// Where an advance stopped.
struct HullContact {
  double time = 0;  ///< no contact in [0, time)
  Vec3 direction;   ///< up to there the hull was on the positive side of the plane normal to it; zero if time is 0
};

/// First contact of the hull with the origin, or nothing if there is none in [0, 1]. The largest component of the
/// corners must be between 2^-100 and 2^20. Conservative: see ccd.h.
std::optional<HullContact> first_contact_with_origin(const MovingHull& hull);

}  // namespace lostopos
