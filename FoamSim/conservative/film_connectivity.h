#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/hold.h"

namespace foamsim {

/// Vertices or triangles that a thread takes at a time.
inline constexpr std::size_t film_grain = 256;

/// Who is next to whom, as plain arrays: what the conservative scheme needs of the mesh as long as it is not remeshed.
/// An entry is a pair (vertex, region); entries are numbered as those of SurfaceGeometry.
struct FilmConnectivity {
  using Corners = std::array<std::uint32_t, 3>;

  std::vector<lostopos::Triangle> triangles;  ///< of films, solids left out
  std::vector<Corners> corners;               ///< vertex slots
  std::vector<Corners> front, back;           ///< entries (corner, p) and (corner, q) for the triangle's labels (p, q)
  std::vector<std::uint32_t> first_corner;    ///< by vertex slot + 1, into corner_list
  std::vector<std::uint32_t> corner_list;     ///< 3 t + k: the triangles around a vertex, ascending
  std::vector<Corners> sheets;                ///< of (corner, the triangle's film): a vertex has a sheet for each film
  std::vector<std::uint32_t> first_sheet;     ///< by vertex slot + 1
  std::vector<std::uint8_t> inner;            ///< by vertex slot, not zero: one film here and at all neighbours
  std::vector<std::uint32_t> first_entry;     ///< by vertex slot + 1
  std::vector<lostopos::Region> regions;      ///< by entry
  std::vector<std::uint8_t> held;             ///< by vertex slot, not zero: it stays where it is

  std::size_t vertex_slots() const { return held.size(); }
  std::size_t sheet_count() const { return first_sheet.back(); }
  std::size_t entries() const { return regions.size(); }
  /// Overwrites everything. `geometry` is that of the mesh as it is now.
  void update(const lostopos::SurfaceMesh& mesh, const SurfaceGeometry& geometry,
              std::span<const lostopos::Hold> held_vertices, std::span<const std::uint8_t> solid);
  /// The triangles' corners around v.
  std::span<const std::uint32_t> around(std::size_t v) const {
    return {corner_list.data() + first_corner[v], corner_list.data() + first_corner[v + 1]};
  }
};

}  // namespace foamsim
