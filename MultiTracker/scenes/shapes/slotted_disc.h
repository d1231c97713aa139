#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace multitracker {

struct SlottedDiscOptions {
  lostopos::Vec3 centre = {0.5, 0.75, 0.5};  ///< L
  double radius = 0.15, slot_width = 0.05;   ///< L
  double slot_depth = 0.25;                  ///< L, from the rim at the lowest y
  double thickness = 0.1;                    ///< L, along z
  long segments = 32;                        ///< of the rim, ≥ 12
  long subdivisions = 1;                     ///< of each triangle into four
};

/// Zalesak's slotted disc (1979), with a thickness: region 1 in the air. The rim is the polygon of its segments, with
/// one side over the slot.
lostopos::SurfaceMesh slotted_disc(const SlottedDiscOptions& options);

}  // namespace multitracker
