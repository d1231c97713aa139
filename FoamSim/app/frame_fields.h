#pragma once

#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace foamsim::app {

/// The values of a field at the corners of every triangle, three each: an array of the file, of vertices or triangles
/// (the length of a vector), or "pressure", the pressure jump across a film over its tension (1/L, see
/// `bubble_pressures`), 0 where one side has none. Throws base::InputError, with the fields that there are, for any
/// other name.
std::vector<double> field_values(const lostopos::SurfaceData& data, const std::string& field);

}  // namespace foamsim::app
