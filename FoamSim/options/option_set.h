#pragma once

#include "FoamSim/options/option_spec.h"
#include "LosTopos/options/option_set.h"

namespace foamsim {

using lostopos::OptionSet;

}  // namespace foamsim
