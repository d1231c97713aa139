#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Opens a region to the air: its triangles towards the air go, with the vertices that are left without any, and in
/// what is left of its boundary the air takes its place. Other numbers stay as they are, and so do attributes. Does
/// nothing where the region has no film towards the air.
///
/// @return the centre of the films that broke, weighted by area, L.
/// @throws base::InputError for the air.
Vec3 burst_region(SurfaceMesh& mesh, Region region);

/// Whether a triangle separates the region from the air.
bool has_film_to_air(const SurfaceMesh& mesh, Region region);

/// The regions with a film towards the air, ascending.
std::vector<Region> regions_at_air(const SurfaceMesh& mesh);

}  // namespace lostopos
