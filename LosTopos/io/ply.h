#pragma once

#include <filesystem>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Reads a PLY file: ascii or binary of either byte order. Element `vertex` with x, y, z and element `face` with the
/// list `vertex_indices` (or `vertex_index`) are wanted, of any scalar types; `region_a` and `region_b` of the faces
/// are the labels p and q, both or neither (then `default_labels`); `solid` becomes a triangle array, `vx`, `vy`, `vz`
/// and `vertex_id` of the vertices the arrays `velocity` and `vertex_id`. Other properties and elements are passed
/// over. Throws InputError with line or byte for a malformed file or faces that are not triangles, FileError when it
/// cannot be read.
SurfaceData read_ply(const std::filesystem::path& path);

/// Writes binary little-endian PLY: vertex x y z (double); face list uchar int vertex_indices, int region_a, int
/// region_b, and uchar solid where a triangle array of that name is not zero throughout; behind x y z, where the data
/// has such arrays, velocity as vx vy vz (double) and vertex_id (int). Every bit of the positions is kept. Throws
/// InputError when the data is not valid (nothing is written then), FileError when it cannot be written.
void write_ply(const std::filesystem::path& path, const SurfaceData& data);

}  // namespace lostopos
