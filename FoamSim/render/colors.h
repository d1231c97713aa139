#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// A well visible colour (linear sRGB) for a region: neighbouring numbers are far apart in hue. Region 0, the air, is
/// grey.
Eigen::Vector3f region_color(std::int32_t region);

/// Gives every film the colour of its bubble, or the mean of its two bubbles' colours.
void color_by_region(Surface& surface);

/// From where to where a colour map reaches.
struct FieldRange {
  double low = 0, high = 1;
};

/// The colour (linear sRGB) of a value in a range, outside of which the ends' colours go on: viridis (van der Walt and
/// Smith 2015), dark to light, at nine places with straight lines between. Not finite: grey.
Eigen::Vector3f field_color(double value, const FieldRange& range);

/// Colours every triangle by the values at its corners (three a triangle).
/// @throws base::InputError  if there are not three values a triangle, or the range is not finite or empty.
void color_by_field(Surface& surface, std::span<const double> values, const FieldRange& range);

/// The least and the largest finite value; wider by a little where they are equal, 0 to 1 where there is none.
FieldRange range_of(std::span<const double> values);

}  // namespace foamsim::render
