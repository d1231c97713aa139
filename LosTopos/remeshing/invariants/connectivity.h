#pragma once

#include <optional>

#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/refusal.h"

namespace lostopos {

/// The link condition for merging the ends of e, which keeps the topology of a two-dimensional complex (Dey,
/// Edelsbrunner, Guha, Nekhayev 1999, "Topology preserving edge contraction"): the ends' common neighbours are just the
/// vertices opposite to e; no two triangles at the ends become the same.
bool meets_link_condition(const SurfaceMesh& mesh, Edge e);

/// The same paper's condition on the complex of the curves where films meet or end, in words: the collapse of e joins
/// no two places of these curves that e itself does not join along a curve, removes no corner, and closes no loop of
/// three border edges.
bool keeps_junctions(const SurfaceMesh& mesh, Edge e);

}  // namespace lostopos
