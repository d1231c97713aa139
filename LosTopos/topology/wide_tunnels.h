#pragma once

#include "LosTopos/topology/region_surface.h"

namespace lostopos {

/// The tunnels through a closed piece of a region's boundary that are not small: its genus, less that of handles which
/// lie within `radius` (L) of a vertex, with all that joins them there. (Guskov and Wood 2001, "Topological noise
/// removal", look for small handles so: around every vertex.) Costs a patch of triangles a vertex, and nothing where a
/// piece has no tunnel.
double wide_tunnels(const SurfaceMesh& mesh, const RegionSurface& surface, const RegionSurface::Piece& piece,
                    double radius);

}  // namespace lostopos
