#pragma once

#include "FoamSim/sheet/velocity/pair_sums.h"

namespace foamsim {

/// Σ_t γ_t·Ψ(m_t) over the sources t of `part`, Ψ(x) = (1/4π) Σ_s γ_s / sqrt(|x − m_s|² + δ²) the potential of those of
/// `all`, L⁵/T²: twice the kinetic energy where both are the same, and the change of it by a small change `part`.
///
/// Only those of `part` that are not zero take part: where they are few among `all`, for each the potential alone at
/// its place, else those at all places by `pairs`. Same bits for any number of threads.
///
/// @param part as many as `all`, at the same places (L).
/// @param delta δ > 0 (L).
double interaction(const VortexSources& part, const VortexSources& all, double delta, PairSummation& pairs);

}  // namespace foamsim
