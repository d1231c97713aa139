#include "Base/options/option_spec.h"

#include <algorithm>
#include <cmath>

namespace base {

std::string to_text(const OptionSpec& spec, const OptionValue& value) {
  if (const auto* number = std::get_if<double>(&value))
    for (const auto& [word, named] : spec.named_numbers)
      if (named == *number) return word;
  return to_text(value);
}

const double* find_named_number(const OptionSpec& spec, std::string_view word) {
  const auto it = std::ranges::find(spec.named_numbers, word, &std::pair<std::string, double>::first);
  return it == spec.named_numbers.end() ? nullptr : &it->second;
}

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

OptionSpec whole_between(long least, long most, long default_value, std::string key, std::string summary) {
  return {std::move(key), default_value, std::move(summary),
          "a whole number from " + std::to_string(least) + " to " + std::to_string(most),
          [least, most](const OptionValue& value) {
            return std::get<long>(value) >= least && std::get<long>(value) <= most;
          }};
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
