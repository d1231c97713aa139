#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// A file format that surfaces are read from and written to.
struct MeshFormat {
  std::string_view extension;    ///< with the dot, in small letters
  std::string_view description;  ///< for lists and help texts
  bool keeps_pair_arrays;        ///< numbers of region pairs and the declared number of regions
  bool keeps_held;               ///< held vertices
  bool keeps_arrays;             ///< vertex and triangle arrays
  /// Where it does not: the arrays that it keeps, of vertices and of triangles.
  std::span<const std::string_view> kept_vertex_arrays, kept_triangle_arrays;
  SurfaceData (*read)(const std::filesystem::path&);
  void (*write)(const std::filesystem::path&, const SurfaceData&);
  double memory_of_byte;  ///< most bytes of memory that reading takes for each of the file
};

/// All formats. Each keeps positions to the bit, triangles and labels; .obj turns triangles and puts them in another
/// order, film by film.
std::span<const MeshFormat> mesh_formats();

/// The extensions of all formats for a message: ".ply, .obj, ...".
std::string mesh_extensions();

/// The format that the path's extension names, in small or capital letters; null when there is none.
const MeshFormat* find_mesh_format(const std::filesystem::path& path);

/// The same; throws InputError when there is none.
const MeshFormat& require_mesh_format(const std::filesystem::path& path);

/// The format that the file's content shows; null when it shows none. Throws FileError when it cannot be read.
const MeshFormat* sniff_mesh_format(const std::filesystem::path& path);

/// Reads a surface in the format that the path's extension names; without a known extension, in the one that the
/// content shows. Throws InputError when there is no such format, when the content is plainly another one's, or when it
/// is malformed, or when reading it may take more than 80% of what memory is left; FileError when the file cannot be
/// read. `to_mesh` takes whatever this returns.
SurfaceData read_surface(const std::filesystem::path& path);

/// Writes a surface in the format that the path's extension names; what that format does not keep is left out (see
/// MeshFormat). Throws InputError for an unknown extension or data that is not valid, before anything is written;
/// FileError when the file cannot be written, which then stays as it was.
void write_surface(const std::filesystem::path& path, const SurfaceData& data);

}  // namespace lostopos
