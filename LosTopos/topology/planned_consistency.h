#pragma once

#include "LosTopos/remeshing/change_plan.h"

namespace lostopos {

/// Whether no two of the planned triangles meet anywhere but at the vertices that they have in common (exact).
bool planned_triangles_are_apart(const ChangePlan& plan);

/// Whether on a turn about each planned edge at `v` the region after a film is the one before the next.
bool planned_labels_are_consistent(const ChangePlan& plan, Vertex v);

}  // namespace lostopos
