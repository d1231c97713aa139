#pragma once

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// What lies behind a plane: points x with normal · x <= offset.
struct CutPlane {
  Eigen::Vector3d normal = {1, 0, 0};  ///< towards what is taken away; any length but 0
  double offset = 0;                   ///< unit of length times the normal's
};

/// The part of a surface behind a plane; triangles that cross it are cut there, with new vertices that neighbours
/// share, so that films end in one line. Borders stay borders.
/// @throws base::InputError  if the normal or the offset is not finite, the normal is zero, or nothing is left.
Surface cut(const Surface& surface, const CutPlane& plane);

}  // namespace foamsim::render
