#pragma once

#include <nlohmann/json_fwd.hpp>

#include "Base/options/option_set.h"

namespace base {

/// Every option with its value in use.
nlohmann::json options_to_json(const OptionSet& options);
/// Sets the options found in `value`; throws InputError for unknown ones.
void options_from_json(const nlohmann::json& value, OptionSet& options);

}  // namespace base
