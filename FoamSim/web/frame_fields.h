#pragma once

#include <string>
#include <vector>

#include "FoamSim/web/surface_measures.h"
#include "LosTopos/io/surface_data.h"

namespace foamsim::web {

/// Numbers on a surface, one a vertex or one a triangle.
struct FrameField {
  std::string name;
  bool on_vertices;
  std::vector<double> values;  ///< NaN where there is none
};

/// The fields of a frame: mean_curvature and pressure_jump, and what its file has (of arrays of several components the
/// length; an array that is called like one of those two takes its place). Not `solid`, which frames have of their own.
std::vector<FrameField> fields_of(const lostopos::SurfaceData& surface, const SurfaceMeasures& measures);

/// Those that `names` asks for, in its order; all where it is empty, none where it is {"none"}. Throws
/// base::InputError, with those that there are, for a name that none has.
std::vector<FrameField> chosen_fields(std::vector<FrameField> fields, const std::vector<std::string>& names);

}  // namespace foamsim::web
