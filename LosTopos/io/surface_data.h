#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A value of one region pair at one vertex, for the order p < q.
struct PairValue {
  Region p, q;
  double value;
  bool operator==(const PairValue&) const = default;
};

/// Named sparse numbers per vertex and region pair: those of vertex v are values[offsets[v]] .. values[offsets[v + 1] −
/// 1], ascending by (p, q).
struct PairArray {
  std::string name;
  std::vector<std::size_t> offsets;  ///< one more than there are vertices
  std::vector<PairValue> values;

  std::span<const PairValue> at(std::size_t vertex) const {
    return std::span(values).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
  bool operator==(const PairArray&) const = default;
};

/// A vertex held by a wire or a solid, and where it is held.
struct HeldVertex {
  std::uint32_t vertex;
  Vec3 position;
  bool operator==(const HeldVertex&) const = default;
};

/// Named numbers that follow the vertices or the triangles, `components` each, in their order.
struct DataArray {
  std::string name;
  int components = 1;
  std::vector<double> values;
  std::string unit = {};  ///< in L and T ("L^2/T"); empty: none, or not known
  bool operator==(const DataArray&) const = default;
};

/// A labelled surface as a file holds it: vertices and triangles numbered from 0 without gaps.
/// Which format carries what besides positions, triangles and labels: see `mesh_formats`.
struct SurfaceData {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Labels> labels;              ///< one a triangle
  std::uint32_t declared_regions = 0;      ///< regions 0 .. n - 1 may occur (.rec); 0: what the labels say
  std::vector<HeldVertex> held;            ///< .rec
  std::vector<PairArray> pair_arrays;      ///< .rec: one
  std::vector<DataArray> vertex_arrays;    ///< .vtp, .vtu; some of .ply and .obj
  std::vector<DataArray> triangle_arrays;  ///< .vtp, .vtu; one of .ply and .fe
  /// .vtp: edges that are drawn besides the triangles, as pairs of vertices (Plateau borders).
  std::vector<std::array<std::uint32_t, 2>> lines;
  bool operator==(const SurfaceData&) const = default;
};

/// The array of that name; null when there is none.
/// @{
const PairArray* find_pair_array(const SurfaceData& data, std::string_view name);
const DataArray* find_array(std::span<const DataArray> arrays, std::string_view name);
/// @}

/// @name Arrays that more formats have than those that keep all
///@{
inline constexpr const char* solid_array = "solid";          ///< of triangles: not 0 for those of a solid
inline constexpr const char* velocity_array = "velocity";    ///< of vertices, 3 components: how they move, L/T
inline constexpr const char* vertex_id_array = "vertex_id";  ///< of vertices: numbers that they keep in all frames
///@}

/// Labels of triangles from a file that has none: the surface of one bubble, region 1, with its normals to the air.
inline constexpr Labels default_labels{Region{1}, air};

/// Limits of the formats' 32-bit integers, and of the mesh's handles.
inline constexpr std::uint64_t most_vertices = 0x7fffffff;
inline constexpr std::uint64_t most_triangles = 0x55555554;
inline constexpr std::uint32_t largest_region = 0x7fffffff;

/// Whether the array can be one of vertex ids: a whole number each that has room in 32 bits.
bool holds_vertex_ids(const DataArray& array);

/// Throws InputError, with the number of the element, unless the data makes a surface: finite positions and lengths in
/// the range of length_range.h, existing and different corners, two different labels of at most `largest_region`,
/// arrays of the right length, everything within the limits. A triangle may occur twice. What a reader returns is
/// valid, and writers refuse what is not.
void validate(const SurfaceData& data);

/// The smallest n such that all regions of labels and pair arrays, and `declared_regions`, are below n.
std::uint32_t region_count(const SurfaceData& data);

/// Vertex i of the data becomes Vertex(i), triangle i Triangle(i). Throws InputError when the data is not valid.
SurfaceMesh to_mesh(const SurfaceData& data);

/// The living vertices and triangles in the order of their slots, without gaps; no arrays or held vertices.
SurfaceData from_mesh(const SurfaceMesh& mesh);

/// The same with what is solid, where anything is: what a frame of a run holds at least.
SurfaceData from_mesh_with_solids(const SurfaceMesh& mesh);

/// The named attribute as an array of the living vertices, in the order of `from_mesh`; nothing where the mesh has none
/// of that name, or one that is no number.
std::optional<DataArray> vertex_array(const SurfaceMesh& mesh, std::string_view name);

/// The same with every named attribute of the mesh that is a number, or several, as an array of its name.
SurfaceData from_mesh_with_attributes(const SurfaceMesh& mesh);

/// Number of each vertex in `from_mesh`'s data, indexed by handle; `Vertex::invalid_index` for dead slots.
std::vector<std::uint32_t> compact_numbers(const SurfaceMesh& mesh);

}  // namespace lostopos
