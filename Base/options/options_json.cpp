#include "Base/options/options_json.h"

#include <nlohmann/json.hpp>

#include "Base/error.h"

namespace base {

using nlohmann::json;

json options_to_json(const OptionSet& options) {
  json value = json::object();
  for (const OptionSpec& spec : options.specs())
    if (std::string text = to_text(spec, options.value(spec.key)); find_named_number(spec, text) != nullptr)
      value[spec.key] = std::move(text);
    else
      std::visit([&](const auto& held) { value[spec.key] = held; }, options.value(spec.key));
  return value;
}

void options_from_json(const json& value, OptionSet& options) {
  for (const auto& [key, held] : value.items()) {
    OptionValue option;
    if (held.is_boolean())
      option = held.get<bool>();
    else if (held.is_number_integer())
      option = held.get<long>();
    else if (held.is_number())
      option = held.get<double>();
    else if (held.is_string())
      option = held.get<std::string>();
    else
      option = held.get<std::vector<std::string>>();
    options.set_default(key, option);
  }
}

}  // namespace base
