#pragma once

#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"
#include "LosTopos/io/xml_reader.h"

namespace lostopos {

/// How the binary arrays of a VTK XML file are encoded, from the attributes of its root element.
struct VtkEncoding {
  bool little_endian = true;
  bool wide_header = false;  ///< an array's byte count is a UInt64, not a UInt32
};

/// Reads the attributes of the root element `VTKFile` just started. Throws InputError for what is not read: another
/// `type` than wanted, compression, unknown byte orders.
VtkEncoding read_vtk_root(const XmlReader& xml, const char* wanted_type);

/// Reads the DataArray element just started, up to and with its end. All numbers become doubles.
DataArray read_vtk_array(XmlReader& xml, const VtkEncoding& encoding);

}  // namespace lostopos
