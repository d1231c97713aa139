#pragma once

#include <string>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace lostopos {

/// Makes what files of other programs hold fit for a simulation, and says what it did, a line each; nothing where
/// nothing was wrong:
/// - vertices that no triangle uses are dropped; numbers close up, arrays and held vertices with them;
/// - a surface whose triangles have their labels the wrong way round, normals out of the second into the first, gets
///   them turned, if it is consistent then and was not before (see audit.h). One with circulation stays as it is.
/// The data has to be valid.
std::vector<std::string> tidy_surface(SurfaceData& data);

}  // namespace lostopos
