#pragma once

#include <string>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Where the regions of films that no edge joins contradict each other, as straight lines through the surface find
/// them: one line through each connected part, all in one direction. Where one film is left for a region, the next has
/// to be entered from it; the outermost region is the same on every line, and the open air where the surface knows it.
/// So a bubble turned inside out is found though the labels around each of its edges agree.
///
/// `whole`: the surface is closed, so that lines come from the outermost region and end there; false: it ends at the
/// walls of a box, of which nothing is known outside. Returns at most `limit` messages. Lines that pass too close to an
/// edge to tell are tried elsewhere, a few times. Cost: n log n, and close to linear in what the lines meet.
std::vector<std::string> contradictions_on_lines(const SurfaceMesh& mesh, bool whole, std::size_t limit);

}  // namespace lostopos
