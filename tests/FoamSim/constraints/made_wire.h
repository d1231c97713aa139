#pragma once

#include <memory>
#include <string>
#include <vector>

#include "FoamSim/constraints/wire.h"

namespace foamsim {

inline constexpr double delta = 0.15, dt = 0.02;
inline constexpr lostopos::Labels air_inside{lostopos::Region(0), lostopos::Region(1)};

/// A wire from its texts, for films of a resolution of 0.2.
inline std::unique_ptr<Wire> made_wire(const std::vector<std::string>& texts,
                                       const WireAirOptions& air = {.interior_weight = 0.02}) {
  std::vector<WireSpec> specs(texts.begin(), texts.end());
  return std::make_unique<Wire>(std::move(specs), air, 0.2, 0);
}

}  // namespace foamsim
