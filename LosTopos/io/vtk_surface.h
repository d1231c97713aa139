#pragma once

#include <filesystem>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Reads ParaView's XML PolyData (.vtp) as far as `write_vtp` writes it and a little beyond: one piece, triangles only,
/// arrays of any number type, format `ascii` or `binary` (inline base64, as it is or compressed by zlib), either byte
/// order and header type, and lines of two points. Values of lines are not kept. Cell arrays `region_a` and `region_b`
/// are the labels p and q, both or neither (then `default_labels`); the other point and cell arrays become
/// `vertex_arrays` and `triangle_arrays`. Throws InputError with the line for anything else, FileError when the file
/// cannot be read.
SurfaceData read_vtp(const std::filesystem::path& path);

/// Writes .vtp: points, lines, triangles, the labels as cell arrays `region_a` and `region_b` (of lines: −1), and the
/// data's arrays (of lines: NaN), all as inline base64, compressed by zlib; every bit is kept. An array's unit is its
/// VTK information UNITS_LABEL. Throws InputError when the data is not valid, when an array is called region_a or
/// region_b or its name is empty, taken twice or not fit for XML (nothing is written then), FileError when the file
/// cannot be written.
void write_vtp(const std::filesystem::path& path, const SurfaceData& data);

/// The same of VTK's XML UnstructuredGrid (.vtu), which programs read that do not know surfaces, such as meshio: lines
/// of two points first, then triangles.
SurfaceData read_vtu(const std::filesystem::path& path);
void write_vtu(const std::filesystem::path& path, const SurfaceData& data);

}  // namespace lostopos
