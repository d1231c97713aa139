#pragma once

#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

struct RepairOptions {
  /// Vertices nearer to each other than this share of the surface's extent (the diagonal of its box) are one.
  double tolerance = 1e-9;
};

/// What a repair did and could not do, a line each.
struct RepairReport {
  std::vector<std::string> done;
  /// What an audit (see audit.h) still finds, and what would help. Elements have the numbers of the repaired surface.
  std::vector<std::string> left;
};

/// Mends what can be mended in a surface from elsewhere, in this order:
/// - vertices at the same place become one, and triangles that vanish by that go;
/// - triangles whose corners are on a line go; what is beyond their longest edge is split at the corner in its middle,
/// so
///   that no gap opens;
/// - of triangles on the same three vertices one stays: of two with the same regions either, and of two bubbles' that
///   touch, one between the two bubbles;
/// - triangles of a film that are wound the other way than the film are turned, and so are films that contradict their
///   neighbours at junctions. A surface with circulation is not turned, here and below;
/// - vertices that no triangle uses go, and a surface that is inside out as a whole is turned (see tidy_surface);
/// - bubbles that are inside out by themselves are turned.
/// Arrays and held vertices follow. Nothing is moved, filled or cut: openings and intersections are left and reported.
/// The data has to be valid (see `validate`); what is sound stays as it is, to the bit. Cost: n log n, besides the
/// audit, and a few searches for each bubble that no film joins to another.
RepairReport repair_surface(SurfaceData& data, const RepairOptions& options = {});

}  // namespace lostopos
