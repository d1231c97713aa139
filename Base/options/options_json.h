#pragma once

#include <nlohmann/json_fwd.hpp>

#include "Base/options/option_set.h"

namespace base {

/// Every option with its value in use.
nlohmann::json options_to_json(const OptionSet& options);

/// Every option with its value, and which of them somebody set: what the options are from which the set starts anew.
nlohmann::json option_state_to_json(const OptionSet& options);
/// Takes back what option_state_to_json gave. Throws InputError for options that are not known, and for values that
/// `options` would not take from anybody.
void option_state_from_json(const nlohmann::json& value, OptionSet& options);

}  // namespace base
