#pragma once

#include "LosTopos/options/option_value.h"

namespace foamsim {

using lostopos::convert_option;
using lostopos::kind_of;
using lostopos::OptionValue;
using lostopos::parse_option;
using lostopos::to_text;

}  // namespace foamsim
