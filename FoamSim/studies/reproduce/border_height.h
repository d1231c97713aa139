#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// How far from the border the films' triangles there reach: the mean over the junction vertices of the area that
/// `averaged` uses, (2/3) Σ area(t at v) / 3, over the length of border that belongs to the vertex, Σ|e| / 2; L. With
/// it grows the deviation from 120° at which `averaged` rests. 0 without a border.
double mean_border_height(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
