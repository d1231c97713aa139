#include "FoamSim/constraints/constraint.h"

#include <nlohmann/json.hpp>

namespace foamsim {

nlohmann::json Constraint::state() const {
  return nullptr;
}

void Constraint::restore(const nlohmann::json& /*state*/) {}

}  // namespace foamsim
