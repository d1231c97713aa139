#pragma once

#include "FoamSim/options/option_value.h"
#include "LosTopos/options/option_spec.h"

namespace foamsim {

using lostopos::flag;
using lostopos::non_negative_number;
using lostopos::OptionSpec;
using lostopos::positive_number;
using lostopos::whole_number;

}  // namespace foamsim
