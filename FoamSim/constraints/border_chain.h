#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The held vertices in order round the films' border, along edges with one triangle and two held ends: from the lowest
/// number on, or from the end of the border with the lower number where it is open, and from there towards the
/// neighbour with the lower number. Throws base::InputError where they do not form one chain of three or more.
std::vector<lostopos::Vertex> border_chain(const lostopos::SurfaceMesh& mesh, std::span<const lostopos::Hold> held);

}  // namespace foamsim
