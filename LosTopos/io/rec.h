#pragma once

#include <filesystem>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// The two binary layouts that go by the name of .rec, all little endian.
enum class RecFlavour {
  /// u64 regions n; u64 vertices, each 3 f64 position and n × n f64 Γ (row-major, i < j used); u64 triangles, each 3
  /// u64
  /// corners and 2 i32 labels; u64 held vertices, each u64 number and 3 f64 position.
  SoapFilm,
  /// u64 vertices, each 3 f64; u64 triangles, each 3 u64 and 2 i32.
  Tracker
};

/// Reads a .rec file of either flavour, told apart by which one's counts account for every byte of the file. Γ is kept
/// sparsely: the pairs that meet at the vertex and those that are not zero. Memory is O(vertices + triangles), whatever
/// the number of regions.
/// Throws InputError with the byte when neither flavour fits or the content is malformed, FileError when it cannot be
/// read.
SurfaceData read_rec(const std::filesystem::path& path);

/// Writes a .rec file. The soap-film flavour takes 8 n² bytes a vertex; more than `largest_rec_bytes` in all is
/// refused. Throws InputError when the data is not valid or too large so (nothing is written then), FileError when the
/// file cannot be written. The tracker flavour leaves out circulation and held vertices.
void write_rec(const std::filesystem::path& path, const SurfaceData& data, RecFlavour flavour = RecFlavour::SoapFilm);

/// The name of the array of vertices and region pairs that the soap-film flavour has.
inline constexpr const char* rec_pair_array = "circulation";

inline constexpr double largest_rec_bytes = 0x1p36;  ///< 64 GiB

/// Reads and writes .arec: the tracker flavour as text, numbers divided by white space. Errors name the line.
/// @{
SurfaceData read_arec(const std::filesystem::path& path);
void write_arec(const std::filesystem::path& path, const SurfaceData& data);
/// @}

}  // namespace lostopos
