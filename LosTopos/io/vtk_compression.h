#pragma once

#include <bit>
#include <optional>
#include <string>
#include <string_view>

namespace lostopos {

/// `bytes` as VTK's vtkZLibDataCompressor lays them out in a file with 64-bit headers of the little end: numbers of
/// blocks and bytes, and the blocks, as two pieces of base64. Throws base::Error when zlib has no memory.
std::string vtk_compress(std::string_view bytes);

/// The bytes of an array that was written so (`encoded`: without base64), with headers of either width and order;
/// nothing when it is damaged. No more memory is taken than so many bytes can stand for (1,032 times their number).
std::optional<std::string> vtk_decompress(std::string_view encoded, std::endian order, bool wide_header);

/// How many bytes the array has when it is decompressed, as its header says; nothing when it cannot be so.
std::optional<std::uint64_t> vtk_decompressed_size(std::string_view encoded, std::endian order, bool wide_header);

}  // namespace lostopos
