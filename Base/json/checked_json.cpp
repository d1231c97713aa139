#include "Base/json/checked_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"

namespace base {

void CheckedJson::refuse(const std::string& message) const {
  throw InputError((what_.empty() ? "it" : what_) + " " + message);
}

CheckedJson CheckedJson::at(const std::string& key) const {
  if (!has(key)) refuse("has no '" + key + "'");
  return {value_->at(key), what_.empty() ? key : what_ + "." + key};
}

bool CheckedJson::has(const std::string& key) const {
  return value_->is_object() && value_->contains(key);
}

std::vector<CheckedJson> CheckedJson::entries() const {
  if (!value_->is_array()) refuse("is not a list");
  std::vector<CheckedJson> entries;
  entries.reserve(value_->size());
  for (const nlohmann::json& entry : *value_) entries.emplace_back(entry, what_);
  return entries;
}

std::vector<CheckedJson> CheckedJson::entries(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) refuse("is not a list of " + std::to_string(count));
  return entries();
}

double CheckedJson::finite_number() const {
  if (!value_->is_number()) refuse("is not a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) refuse("is not finite");
  return number;
}

double CheckedJson::positive_number() const {
  const double number = finite_number();
  if (!(number > 0)) refuse("is not > 0");
  return number;
}

std::vector<double> CheckedJson::finite_numbers(std::size_t count) const {
  std::vector<double> numbers;
  for (const CheckedJson& entry : entries(count)) numbers.push_back(entry.finite_number());
  return numbers;
}

std::int64_t CheckedJson::whole_number(std::int64_t least, std::int64_t most) const {
  if (!value_->is_number_integer()) refuse("is not a whole number");
  const bool too_large =
      value_->is_number_unsigned() &&
      value_->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const auto number = too_large ? std::numeric_limits<std::int64_t>::max() : value_->get<std::int64_t>();
  if (too_large || number < least || number > most)
    refuse("is not from " + std::to_string(least) + " to " + std::to_string(most));
  return number;
}

std::uint32_t CheckedJson::index() const {
  return static_cast<std::uint32_t>(whole_number(0, std::numeric_limits<std::uint32_t>::max() - 1));
}

const std::string& CheckedJson::text() const {
  if (!value_->is_string()) refuse("is not a text");
  return value_->get_ref<const std::string&>();
}

const std::vector<std::uint8_t>& CheckedJson::bytes() const {
  if (!value_->is_binary()) refuse("is not binary data");
  return value_->get_binary();
}

}  // namespace base
