#pragma once

#include <filesystem>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Reads a Wavefront OBJ file: `v` (further numbers after x y z are passed over) and triangles `f` in any of the forms
/// v, v/vt, v//vn, v/vt/vn, with numbers from 1 or, negative, back from the last vertex.
///
/// Labels: a group named `region_P_Q` gives the triangles after it the labels p = P, q = Q (right-hand normal out of P
/// into Q). Triangles in no such group have `default_labels`. Texture, normals, materials, objects and lines are passed
/// over. Comments `#velocity X Y Z` and `#vertex_id N` behind a vertex make the arrays of these names.
/// Throws InputError with the line for a malformed file or faces that are not triangles, FileError when it cannot be
/// read.
SurfaceData read_obj(const std::filesystem::path& path);

enum class ObjNormals { without, with };

/// Writes OBJ with a line `g region_P_Q film_N` a film (see film_numbers) and all its triangles behind it, turned so
/// that their normals point out of P, the higher region, into Q: order and windings do not stay, positions read back as
/// the same bits. With normals each vertex has the mean of those of its triangles, by their area, each out of the
/// higher region into the lower. Arrays `velocity` and `vertex_id` become comments behind each vertex, as they are
/// read. Throws InputError when the data is not valid (nothing is written then), FileError when it cannot be written.
/// @{
void write_obj(const std::filesystem::path& path, const SurfaceData& data, ObjNormals normals);
void write_obj(const std::filesystem::path& path, const SurfaceData& data);
/// @}

}  // namespace lostopos
