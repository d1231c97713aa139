#pragma once

#include <vector>

#include "FoamSim/render/film_mesh.h"

namespace foamsim::render {

/// Lines through the ends of `segments`, where two of them meet with a bend of less than 60 degrees with one tangent
/// there (cubic Hermite curves with the tangents of Catmull and Rom 1974), each in `parts` straight pieces. Where three
/// or more meet, or one ends, or the bend is sharper, the line has a corner. Ends are told to be one by their
/// coordinates.
std::vector<Segment> smooth_lines(const std::vector<Segment>& segments, int parts);

}  // namespace foamsim::render
