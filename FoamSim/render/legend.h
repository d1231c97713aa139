#pragma once

#include <string>

#include "FoamSim/render/camera.h"
#include "FoamSim/render/colors.h"
#include "FoamSim/render/image.h"
#include "FoamSim/render/render.h"

namespace foamsim::render {

/// Draws what the colours of a field mean at the right edge: a bar from the range's low end, at the bottom, to its high
/// end, both with their numbers, and the field's name above. A picture that is too small for it stays as it is.
void draw_legend(Image& image, const std::string& name, const FieldRange& range, Background background);

/// Draws a line of a round length at the lower left corner, as long as that length looks in the plane through the
/// camera's target, and writes the length below it. `unit`: behind the number ("L").
void draw_scale_bar(Image& image, const Camera& camera, const std::string& unit, Background background);

/// Writes a text at the upper left corner.
void draw_label(Image& image, const std::string& text, Background background);

}  // namespace foamsim::render
