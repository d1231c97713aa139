#pragma once

#include <span>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Marks the vertices as held whole and every triangle whose three corners are among them as solid. The marks wait in
/// the mesh as the attributes "hold" and "solid", which the tracker takes over.
void mark_held(lostopos::SurfaceMesh& mesh, std::span<const lostopos::Vertex> vertices);

/// The second half alone: triangles with three corners among the vertices are solid.
void mark_solids(lostopos::SurfaceMesh& mesh, std::span<const lostopos::Vertex> held);

}  // namespace foamsim
