#pragma once

#include <Eigen/Core>

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// A sphere with n triangles around its equator (about x; n a multiple of 4), labels (inside, outside).
Surface sphere(int n, double radius, const Eigen::Vector3d& centre = {0, 0, 0}, int inside = 1, int outside = 0);

/// The equal double bubble at rest: unit spheres about (±1/2, 0, 0), a disc of radius √3/2 between them, n triangles
/// around.
Surface double_bubble(int n);

/// Adds the triangles of `other`.
void append(Surface& surface, const Surface& other);

}  // namespace foamsim::render
