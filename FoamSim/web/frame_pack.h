#pragma once

#include <string>
#include <vector>

#include "FoamSim/web/frame_fields.h"
#include "FoamSim/web/surface_measures.h"
#include "LosTopos/io/surface_data.h"

namespace foamsim::web {

/// How exactly numbers are sent.
enum class Precision {
  quantised,  ///< positions and fields in 65,535 steps of their range
  single,     ///< 32-bit floating point
};

/// A frame as the viewer reads it (web/src/frame.js): "FSF1", the length of a JSON head (4 bytes, little-endian), the
/// head, and arrays one behind the other. The head has `step`, `time`, `precision`, the `arrays` (name, type, count,
/// components, whether each number is the difference to the one before), the `box` of positions, the regions of each
/// film as `pairs`, `fields` (name, on, range, and the 2nd and 98th percentile as `usual`) and `bubbles`. Arrays stand
/// byte plane by byte plane, the lowest bytes of all numbers first, which compresses well: `positions`, `triangles`,
/// `pair` (by triangle), `solid` where there is one, `borders`, and "field/NAME" for each field, where the number 65535
/// or NaN is none.
std::string pack_frame(const lostopos::SurfaceData& surface, const SurfaceMeasures& measures,
                       const std::vector<FrameField>& fields, long step, double time, Precision precision);

/// The bubbles of a frame, as its head and the run's description have them: a list [region, volume, area, pressure,
/// faces, x, y, z] each, as JSON text.
std::string bubbles_json(const std::vector<BubbleMeasures>& bubbles);

}  // namespace foamsim::web
