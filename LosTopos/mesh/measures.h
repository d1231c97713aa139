#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Corner positions of t in the order of its vertices.
std::array<Vec3, 3> corners(const SurfaceMesh& mesh, Triangle t);
/// Half the cross product of two sides: the right-hand normal times the area (L²).
Vec3 area_vector(const SurfaceMesh& mesh, Triangle t);
double area(const SurfaceMesh& mesh, Triangle t);
Vec3 barycentre(const SurfaceMesh& mesh, Triangle t);
double length(const SurfaceMesh& mesh, Edge e);

/// Mean length of all edges (L); 0 for a mesh without edges.
double mean_edge_length(const SurfaceMesh& mesh);
/// Sum of the areas of all triangles (L²).
double total_area(const SurfaceMesh& mesh);
/// The same with the vertices at `positions` (L, by slot).
double total_area(const SurfaceMesh& mesh, std::span<const Vec3> positions);
/// Area-weighted centre of all triangles (L); zero for an empty mesh.
Vec3 surface_centroid(const SurfaceMesh& mesh);

struct RegionVolume {
  Region region;
  double volume;  ///< L³; the air's is minus the sum of the others' for a closed surface
};
/// Volume enclosed by each region's boundary by the divergence theorem, sorted by region, the air included. Summed
/// relative to the surface's centroid, so that a distant origin costs no digits. Cost and memory grow with the
/// triangles, not with the largest label.
std::vector<RegionVolume> region_volumes(const SurfaceMesh& mesh);

/// The volumes of the regions whose boundary is closed, sorted by region, the air included where it is one. A region
/// that an open film bounds, one that ends at a wire, has no volume.
std::vector<RegionVolume> closed_region_volumes(const SurfaceMesh& mesh);

/// Largest |V/V0 − 1| over the regions of both lists but the air; both are sorted by region. Regions that were empty at
/// the start are left out, and so are those that are not there now: they have vanished by design (a region collapse, or
/// bubbles that became one), and have not lost their volume to errors.
double largest_volume_drift(const std::vector<RegionVolume>& now, const std::vector<RegionVolume>& start);

/// The regions in use, ascending.
std::vector<Region> regions(const SurfaceMesh& mesh);

/// Vertices − edges + triangles of the whole complex.
long euler_characteristic(const SurfaceMesh& mesh);

/// Edges that only one triangle uses: the surface ends there.
std::size_t open_edge_count(const SurfaceMesh& mesh);
std::size_t junction_edge_count(const SurfaceMesh& mesh);

}  // namespace lostopos
