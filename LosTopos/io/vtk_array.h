#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"
#include "LosTopos/io/xml_reader.h"

namespace lostopos {

inline constexpr std::uint8_t vtk_line = 3, vtk_triangle = 5;  ///< types of cells

/// How the binary arrays of a VTK XML file are encoded, from the attributes of its root element.
struct VtkEncoding {
  bool little_endian = true;
  bool wide_header = false;  ///< an array's byte count is a UInt64, not a UInt32
  bool compressed = false;   ///< by zlib
};

/// Reads the attributes of the root element `VTKFile` just started. Throws InputError for what is not read: another
/// `type` than wanted, compression but by zlib, unknown byte orders.
VtkEncoding read_vtk_root(const XmlReader& xml, const char* wanted_type);

/// Reads the DataArray element just started, up to and with its end. All numbers become doubles. Throws
/// InputError for what is damaged, and for numbers that would take more than 80% of what memory is left.
DataArray read_vtk_array(XmlReader& xml, const VtkEncoding& encoding);

}  // namespace lostopos
