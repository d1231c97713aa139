#pragma once

#include "LosTopos/mesh/audit.h"

namespace lostopos {

/// The part of an audit that nothing else can be asked before: that the lists of vertices, edges and triangles agree in
/// both directions, that labels are of two regions and coordinates finite, and that no vertex is isolated. `mesh` may
/// be anything whose arrays have the lengths that they should have. Broken links are found first, isolated vertices
/// last. Nearly linear in the size of the mesh.
AuditReport audit_links(const SurfaceMesh& mesh, std::size_t max_findings);

}  // namespace lostopos
