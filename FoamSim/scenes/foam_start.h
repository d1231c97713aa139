#pragma once

#include <cstdint>
#include <string>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A foam that is made here: spheres on a jittered grid, regions 1, 2, …, that have grown (as in scene `growth`, in
/// steps of 0.02 until 0.5, at edges of 0.15) until their neighbours' films have joined. A second for eight of them,
/// not yet at rest.
lostopos::SurfaceMesh grown_foam(long spheres, std::uint64_t seed);

/// A foam of Voronoi cells in a box (lostopos::voronoi_foam), whose bubbles have the volume of a ball of radius 0.5 in
/// the mean and, at edges of 0.15, some 300 triangles each.
lostopos::SurfaceMesh voronoi_bubbles(long bubbles, int relaxations, std::uint64_t seed);

/// Positions, triangles and labels of a mesh in a folder that a run of the reference program has left, without its
/// circulation. Throws base::InputError, with what is missing, where there is no such folder or file.
lostopos::SurfaceMesh mesh_of_run(const std::string& folder, const std::string& file);
/// Path of such a mesh; throws as above.
std::string path_of_mesh(const std::string& folder, const std::string& file);

}  // namespace foamsim
