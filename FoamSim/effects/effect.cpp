#include "FoamSim/effects/effect.h"

#include <nlohmann/json.hpp>

namespace foamsim {

nlohmann::json Effect::state() const {
  return nullptr;
}

void Effect::restore(const nlohmann::json& /*state*/) {}

}  // namespace foamsim
