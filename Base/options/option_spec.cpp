#include "Base/options/option_spec.h"

#include <cmath>

namespace base {

OptionSpec positive_number(std::string key, double default_value, std::string summary) {
  return {std::move(key), default_value, std::move(summary), "a finite number > 0", [](const OptionValue& value) {
            return std::isfinite(std::get<double>(value)) && std::get<double>(value) > 0;
          }};
}

OptionSpec non_negative_number(std::string key, double default_value, std::string summary) {
  return {std::move(key), default_value, std::move(summary), "a finite number >= 0", [](const OptionValue& value) {
            return std::isfinite(std::get<double>(value)) && std::get<double>(value) >= 0;
          }};
}

OptionSpec whole_number(std::string key, long default_value, long least, std::string summary) {
  return {std::move(key), default_value, std::move(summary), "a whole number >= " + std::to_string(least),
          [least](const OptionValue& value) { return std::get<long>(value) >= least; }};
}

OptionSpec flag(std::string key, bool default_value, std::string summary) {
  return {std::move(key), default_value, std::move(summary), "true or false"};
}

OptionSpec word_from(std::string key, OptionValue default_value, std::string summary, std::string kind,
                     std::vector<std::string> words) {
  OptionSpec spec{std::move(key), std::move(default_value), std::move(summary), ""};
  for (const std::string& word : words) spec.allowed += (spec.allowed.empty() ? "one of " : ", ") + word;
  spec.words = std::move(words);
  spec.words_are = std::move(kind);
  return spec;
}

}  // namespace base
