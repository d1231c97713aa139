#pragma once

#include <map>

#include "FoamSim/sheet/circulation.h"

namespace foamsim {

using Values = std::map<RegionPair, double>;

/// Γ at v, by pair.
inline Values values_at(const CirculationField& circulation, lostopos::Vertex v) {
  Values values;
  for (const auto& [pair, value] : circulation.at(v)) values[pair] = value;
  return values;
}

}  // namespace foamsim
