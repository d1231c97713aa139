#pragma once

#include <cstddef>
#include <optional>

#include "LosTopos/remeshing/change_plan.h"

namespace lostopos {

/// Cancels planned triangles that have the same three vertices: films between (p, q) and (q, r) become one between
/// (p, r), or vanish where p = r. Returns the number of planned triangles that are gone, or nothing when two coincide
/// that have no region between them.
std::optional<std::size_t> cancel_coincident(ChangePlan& plan);

}  // namespace lostopos
