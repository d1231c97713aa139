#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "LosTopos/io/byte_reader.h"

namespace lostopos {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a value of that type in a binary file.
std::size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;                       ///< of the value, or of each list entry
  std::optional<PlyType> count_type;  ///< of a list's length; none for a scalar
  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
  /// Place of the first property with one of the names.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  ///< from "ply" to "end_header"
};

/// Reads from the start of the file up to and with the end of the line "end_header". Throws InputError with the line.
PlyHeader read_ply_header(ByteReader& bytes);

}  // namespace lostopos
