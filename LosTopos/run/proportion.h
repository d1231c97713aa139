#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos::run {

/// Throws base::InputError where edges are out of all proportion to the resolution (L, > 0), as no run leaves them:
/// long ones, where they would be remeshed, would take all of the memory there is, and a surface that has shrunk to a
/// point keeps the search for collisions busy for hours. For surfaces that come from somebody else's file.
void require_proportion(const SurfaceMesh& mesh, double resolution, bool remeshing);

}  // namespace lostopos::run
