#pragma once

#include "LosTopos/names/nearest_name.h"

namespace foamsim {

using lostopos::find_by_name;
using lostopos::nearest_name;
using lostopos::unknown_name_message;

}  // namespace foamsim
