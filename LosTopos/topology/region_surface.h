#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// The boundary of a region as it is seen from within: the sides of triangles that face it, joined where two of them
/// meet at an edge with the region between. So it is a surface without junctions, and closed where films are: where the
/// region touches itself in an edge or a vertex, it has two of them in one place.
///
/// Sides are numbered by ascending triangle. Half-edge 3 s + k of side s lies opposite its corner k, and corner 3 s + k
/// is corner k of its triangle.
class RegionSurface {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  RegionSurface(const SurfaceMesh& mesh, Region region);

  std::size_t size() const { return sides_.size(); }
  Triangle triangle(std::size_t side) const { return sides_[side]; }
  /// The half-edge on the other side of this one, or none where a film ends.
  std::uint32_t across(std::size_t half_edge) const { return across_[half_edge]; }
  /// The vertices of the surface, by corner, from 0; and how many there are.
  std::uint32_t vertex(std::size_t corner) const { return vertex_[corner]; }
  std::size_t vertex_count() const { return vertex_count_; }
  /// The two pairs of corners that a half-edge and the one across it have in one place.
  std::array<std::array<std::size_t, 2>, 2> joined_corners(const SurfaceMesh& mesh, std::size_t half_edge) const;

  /// Connected parts of the surface.
  struct Piece {
    std::vector<std::uint32_t> sides;
    double volume = 0;  ///< that it encloses, L³; negative: the region is around it
    double genus = 0;   ///< of a closed piece; else half of what its Euler characteristic is less than 2
    bool closed = true;
  };
  /// Ordered by their first side.
  std::vector<Piece> pieces(const SurfaceMesh& mesh) const;

 private:
  void join_sides(const SurfaceMesh& mesh, Region region);
  void join(const SurfaceMesh& mesh, Edge e, std::uint32_t s, std::uint32_t t);
  void number_vertices(const SurfaceMesh& mesh);
  void measure(const SurfaceMesh& mesh, Piece& piece, std::vector<char>& is_counted) const;

  std::vector<Triangle> sides_;
  std::vector<char> faces_forward_;    // by side: the region is in front of the triangle's right-hand normal
  std::vector<std::uint32_t> across_;  // by half-edge
  std::vector<std::uint32_t> vertex_;  // by corner
  std::size_t vertex_count_ = 0;
};

}  // namespace lostopos
