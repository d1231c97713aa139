#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// κ_e^r: length times signed dihedral angle of region r's boundary at an edge (L·rad), positive where r is convex.
struct RegionEdgeCurvature {
  lostopos::Region region;
  double kappa;
};

/// What curvature and metrics need of the whole surface, computed once for a given set of positions: areas, lengths,
/// edge curvature per region, and the regions at every vertex. Arrays are indexed by handle and reused from step to
/// step.
class SurfaceGeometry {
 public:
  /// Recomputes everything for the mesh as it is now, in parallel; results do not depend on the number of threads.
  /// `solid` (by triangle slot, may be empty): not zero for triangles of a solid.
  void update(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid = {});

  double area(lostopos::Triangle t) const { return areas_[t.index()]; }
  const lostopos::Vec3& unit_normal(lostopos::Triangle t) const { return normals_[t.index()]; }
  double length(lostopos::Edge e) const { return lengths_[e.index()]; }
  /// Mean length of all edges (L).
  double mean_edge_length() const { return mean_edge_length_; }
  /// Area of all films (L²); triangles of a solid are none.
  double total_area() const { return total_area_; }

  /// The regions at v, ascending.
  std::span<const lostopos::Region> regions(lostopos::Vertex v) const { return row(vertex_regions_, vertex_begin_, v); }
  /// κ for every region at e, ascending by region; 0 where other than two triangles of the region meet at e.
  std::span<const RegionEdgeCurvature> curvatures(lostopos::Edge e) const {
    return row(edge_curvatures_, edge_begin_, e);
  }
  /// Where v's regions stand in arrays that hold one value per (vertex, region).
  std::size_t first_entry(lostopos::Vertex v) const { return vertex_begin_[v.index()]; }
  std::size_t entries() const { return vertex_regions_.size(); }

 private:
  template <class T, class H>
  static std::span<const T> row(const std::vector<T>& values, const std::vector<std::size_t>& begin, H h) {
    return {values.data() + begin[h.index()], values.data() + begin[h.index() + 1]};
  }
  void measure_triangles(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid);
  void measure_edges(const lostopos::SurfaceMesh& mesh);
  void list_regions(const lostopos::SurfaceMesh& mesh);

  std::vector<double> areas_, lengths_;
  std::vector<lostopos::Vec3> normals_;
  std::vector<std::size_t> vertex_begin_, edge_begin_;
  std::vector<lostopos::Region> vertex_regions_;
  std::vector<RegionEdgeCurvature> edge_curvatures_;
  double mean_edge_length_ = 0, total_area_ = 0;
};

/// Whether t is part of a solid. `solid`: by triangle slot, not zero for these (see SurfaceTracker::solid); or empty.
inline bool is_solid(lostopos::Triangle t, std::span<const std::uint8_t> solid) {
  return !solid.empty() && solid[t.index()] != 0;
}

/// The dihedral angle of region r's boundary at edge e (rad, in (−π, π]), signed, positive where r is convex, from the
/// triangles' unit normals; 0 unless exactly two triangles bound r there.
double signed_dihedral_angle(const lostopos::SurfaceMesh& mesh, lostopos::Edge e, lostopos::Region r,
                             std::span<const lostopos::Vec3> unit_normals);

}  // namespace foamsim
