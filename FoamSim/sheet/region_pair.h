#pragma once

#include <compare>

#include "LosTopos/mesh/handles.h"

namespace foamsim {

/// An unordered pair of regions, kept as low < high. Quantities that change sign with the order, like Γ^{pq} = −Γ^{qp},
/// are stored for (low, high); `sign` gives the factor for the order asked.
struct RegionPair {
  lostopos::Region low, high;

  constexpr RegionPair(lostopos::Region p, lostopos::Region q) : low(p < q ? p : q), high(p < q ? q : p) {}
  constexpr explicit RegionPair(lostopos::Labels labels) : RegionPair(labels.p, labels.q) {}
  static constexpr double sign(lostopos::Labels labels) { return labels.p < labels.q ? 1.0 : -1.0; }
  constexpr auto operator<=>(const RegionPair&) const = default;
};

}  // namespace foamsim
