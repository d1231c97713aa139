#include "Base/options/options_json.h"

#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"

namespace base {

using nlohmann::json;

namespace {

std::vector<std::string> words_of(const CheckedJson& list) {
  std::vector<std::string> words;
  for (const CheckedJson& word : list.entries()) words.push_back(word.text());
  return words;
}

OptionValue option_from(const CheckedJson& value) {
  const json& held = value.json();
  if (held.is_boolean()) return held.get<bool>();
  if (held.is_number_integer()) return static_cast<long>(value.whole_number(std::numeric_limits<std::int64_t>::min()));
  if (held.is_number()) return held.get<double>();
  if (held.is_string()) return held.get<std::string>();
  return words_of(value);
}

}  // namespace

json options_to_json(const OptionSet& options) {
  json value = json::object();
  for (const OptionSpec& spec : options.specs())
    if (std::string text = to_text(spec, options.value(spec.key)); find_named_number(spec, text) != nullptr)
      value[spec.key] = std::move(text);
    else
      std::visit([&](const auto& held) { value[spec.key] = held; }, options.value(spec.key));
  return value;
}

json option_state_to_json(const OptionSet& options) {
  json set = json::array();
  for (const OptionSpec& spec : options.specs())
    if (options.is_set(spec.key)) set.push_back(spec.key);
  return {{"values", options_to_json(options)}, {"set", std::move(set)}};
}

void option_state_from_json(const json& value, OptionSet& options) {
  const CheckedJson state(value, "options");
  const CheckedJson values = state.at("values");
  if (!values.json().is_object()) values.refuse("is not an object");
  // Whether a value may be is what `set` looks at.
  OptionSet checked = options;
  for (const auto& [key, held] : values.json().items()) {
    const OptionValue option = option_from({held, key});
    checked.set(key, option, "options");
    options.set_default(key, option);
  }
  for (const std::string& key : words_of(state.at("set"))) options.set(key, option_from(values.at(key)), "options");
}

}  // namespace base
