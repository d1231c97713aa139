#pragma once

#include <filesystem>
#include <string_view>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// The triangle array, and what stands for it in a file: a film's tension, in units of the file's own; 1 where there is
/// none.
inline constexpr const char* tension_array = "tension";

/// Reads a datafile of Surface Evolver (Brakke 1992; manual, "The datafile"), one that it has dumped or of that kind:
/// numbers alone where numbers stand, facets of three edges, linear, in open space of three dimensions.
///
/// Body n is region n, or what its `original` says; facets' normals point out of the body that names them with a plus.
/// Where no facet has a body, labels are `default_labels`. Vertices that are `fixed` are held where they stand; where
/// tensions (`tension`, `density`) of facets are not all 1, they are an array of the triangles. Colours and what the
/// view is like are passed over, and so are the volumes that bodies are to have and all behind `read`.
///
/// Throws InputError with the line for a malformed file, and for what no surface here has: constraints, boundaries,
/// periodic space, quantities, tensions of edges, prescribed pressures and densities of bodies, expressions and macros.
/// FileError when it cannot be read.
SurfaceData read_fe(const std::filesystem::path& path);

/// Whether a text that starts so is such a datafile.
bool starts_like_fe(std::string_view start);

/// Writes such a datafile: vertex, facet and body numbers are ours, from 1, those of bodies the regions'. Bodies have
/// the volume that their facets enclose, where these are closed; the air is none. `fixed` are held vertices, corners of
/// triangles that are `solid`, which have no tension, and where films end freely, which they would not do for long.
/// Tensions are those of the array, where there is one. Numbers read back as the same bits. Throws InputError when the
/// data is not valid (nothing is written then), FileError when it cannot be written.
void write_fe(const std::filesystem::path& path, const SurfaceData& data);

}  // namespace lostopos
