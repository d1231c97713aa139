#pragma once

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// Every bubble with films of its own, moved away from the middle of all: by `factor` times the distance between its
/// middle and theirs, the means of the films' corners. A film between two bubbles is there twice. Region 0 is the air;
/// hidden triangles are left out. Labels keep telling films apart.
/// @throws base::InputError  if the factor is not in [0, 100] or the surface has no bubbles.
Surface explode(const Surface& surface, double factor);

}  // namespace foamsim::render
