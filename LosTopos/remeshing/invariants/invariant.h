#pragma once

#include <optional>
#include <span>

#include "LosTopos/remeshing/change_plan.h"
#include "LosTopos/remeshing/limits.h"
#include "LosTopos/remeshing/refusal.h"

namespace lostopos {

/// A rule that a measured plan has to obey, and the reason that is given when it does not.
struct Invariant {
  Refusal refusal;
  bool (*holds)(const ChangePlan& plan, const Limits& limits);
};

/// The refusal of the first invariant that does not hold.
inline std::optional<Refusal> first_broken(std::span<const Invariant> invariants, const ChangePlan& plan,
                                           const Limits& limits) {
  for (const Invariant& invariant : invariants)
    if (!invariant.holds(plan, limits)) return invariant.refusal;
  return {};
}

}  // namespace lostopos
