#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The ellipsoid (0.6, 1, 1), an icosphere of n ≥ 2 subdivisions scaled in x, held at the vertices at edge distance 2
/// from its pole (−0.6, 0, 0): 12 of them, a closed loop.
lostopos::SurfaceMesh held_ellipsoid(long n);

/// Two unit spheres of revolution about x that overlap by n/3 rings of n and are one bubble: held at the waist, m
/// vertices in the plane x = 0. The right half is by up to a thousandth smaller, so that the balance, which is
/// unstable, tips. n ≥ 6, m ≥ 3.
lostopos::SurfaceMesh peanut(long n, long m);

/// Bubbles 1 and 2 of radius 4 that overlap by n/3 rings of n and share a flat wall at x = 0, each held at its ring n/6
/// + 1 of m vertices; and below them at y = −6 the mouth of a straw: a disc of radius 1 in n/2 triangles about a free
/// centre, closed by a solid cone to a tip at y = −7, region 3. Rim and tip are held. n ≥ 6, m ≥ 3.
lostopos::SurfaceMesh carousel(long n, long m);

}  // namespace foamsim
