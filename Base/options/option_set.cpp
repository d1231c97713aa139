#include "Base/options/option_set.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "Base/error.h"
#include "Base/names/nearest_name.h"

namespace base {
namespace {

std::string prefix(std::string_view where) {
  return where.empty() ? std::string() : std::string(where) + ": ";
}

void require_known_words(const OptionSpec& spec, const OptionValue& value, std::string_view where) {
  const auto require = [&](const std::string& word) {
    if (std::ranges::find(spec.words, word) != spec.words.end()) return;
    const std::vector<std::string_view> known(spec.words.begin(), spec.words.end());
    throw InputError(prefix(where) + unknown_name_message(spec.words_are, word, known));
  };
  if (const auto* word = std::get_if<std::string>(&value)) require(*word);
  if (const auto* list = std::get_if<Words>(&value)) std::ranges::for_each(*list, require);
}

void require_allowed(const OptionSpec& spec, const OptionValue& value, std::string_view where) {
  if (!spec.words.empty()) require_known_words(spec, value, where);
  const auto* number = std::get_if<double>(&value);
  const bool finite = number == nullptr || std::isfinite(*number);
  if (finite && (!spec.accepts || spec.accepts(value))) return;
  std::string others;
  for (const auto& [word, named] : spec.named_numbers) others += ", or " + word;
  throw InputError(prefix(where) + spec.key + " = " + to_text(value) + " is not allowed; it has to be " +
                   (spec.allowed.empty() ? "finite" : spec.allowed) + others);
}

// A word that stands for a number is that number; it need not be one that could be given as such.
std::optional<OptionValue> named_number(const OptionSpec& spec, const OptionValue& value) {
  const auto* word = std::get_if<std::string>(&value);
  const double* number = word == nullptr ? nullptr : find_named_number(spec, *word);
  return number == nullptr ? std::nullopt : std::optional<OptionValue>(*number);
}

// "scene 'a'", "scenes 'a', 'b'": what has an option of this key; empty: nothing.
std::string owners_among(const std::vector<OptionSpec>& specs, std::string_view key) {
  std::string kind, names;
  int count = 0;
  for (const OptionSpec& spec : specs) {
    if (spec.key != key) continue;
    kind = spec.owner.kind;
    names += (count++ == 0 ? " '" : ", '") + spec.owner.name + "'";
  }
  return kind + (count > 1 ? "s" : "") + names;
}

}  // namespace

OptionSet::OptionSet(std::vector<OptionSpec> specs, std::string listed_by, std::vector<OptionSpec> elsewhere)
    : specs_(std::move(specs)), elsewhere_(std::move(elsewhere)), listed_by_(std::move(listed_by)) {
  for (const OptionSpec& spec : specs_) entries_.push_back({spec.default_value});
}

std::size_t OptionSet::place_of(std::string_view key, std::string_view where) const {
  const auto it = std::ranges::find(specs_, key, &OptionSpec::key);
  if (it != specs_.end()) return static_cast<std::size_t>(it - specs_.begin());
  if (const std::string owners = owners_among(elsewhere_, key); !owners.empty())
    throw InputError(prefix(where) + "option '" + std::string(key) + "' belongs to the " + owners +
                     "; it has no meaning here");
  std::vector<std::string_view> known;
  for (const OptionSpec& spec : specs_) known.push_back(spec.key);
  throw InputError(prefix(where) + unknown_name_message("option", key, known, listed_by_));
}

void OptionSet::set_text(std::string_view key, std::string_view text, std::string_view where) {
  const std::size_t place = place_of(key, where);
  if (find_named_number(specs_[place], text) != nullptr) return set(key, std::string(text), where);
  try {
    set(key, parse_option(text, specs_[place].default_value), where);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.starts_with(prefix(where)) && !where.empty()) throw;
    std::string others;
    for (const auto& [word, named] : specs_[place].named_numbers) others += ", nor is it '" + word + "'";
    throw InputError(prefix(where) + std::string(key) + ": " + message + others);
  }
}

void OptionSet::set(std::string_view key, const OptionValue& value, std::string_view where) {
  const std::size_t place = place_of(key, where);
  if (std::optional<OptionValue> named = named_number(specs_[place], value)) {
    entries_[place] = {std::move(*named), true};
    return;
  }
  OptionValue converted;
  try {
    converted = convert_option(value, specs_[place].default_value);
  } catch (const InputError& error) {
    throw InputError(prefix(where) + std::string(key) + ": " + error.what());
  }
  require_allowed(specs_[place], converted, where);
  entries_[place] = {std::move(converted), true};
}

void OptionSet::append(std::string_view key, std::string_view words, std::string_view where) {
  const std::size_t place = place_of(key, where);
  const auto* held = std::get_if<Words>(&entries_[place].value);
  if (held == nullptr)
    throw InputError(prefix(where) + std::string(key) + " holds " + std::string(kind_of(entries_[place].value)) +
                     "; += is for lists");
  std::vector<std::string> all = *held;
  const OptionValue added = parse_option(words, specs_[place].default_value);
  for (const std::string& word : std::get<Words>(added))
    if (std::ranges::find(all, word) == all.end()) all.push_back(word);
  set(key, all, where);
}

void OptionSet::set_default(std::string_view key, const OptionValue& value) {
  const std::size_t place = place_of(key, "default");
  std::optional<OptionValue> named = named_number(specs_[place], value);
  entries_[place].value = named ? std::move(*named) : convert_option(value, specs_[place].default_value);
}

void OptionSet::unset(std::string_view key) {
  const std::size_t place = place_of(key, "");
  entries_[place] = {specs_[place].default_value, false};
}

void OptionSet::set_assignment(std::string_view assignment, std::string_view where) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw InputError(prefix(where) + "'" + std::string(assignment) + "' is not of the form key=value");
  const std::string_view text = assignment.substr(equals + 1);
  if (assignment[equals - 1] == '+')
    append(assignment.substr(0, equals - 1), text, where);
  else
    set_text(assignment.substr(0, equals), text, where);
}

const OptionValue& OptionSet::value(std::string_view key) const {
  return entries_[place_of(key, "")].value;
}

bool OptionSet::has(std::string_view key) const {
  return std::ranges::find(specs_, key, &OptionSpec::key) != specs_.end();
}

bool OptionSet::is_set(std::string_view key) const {
  return entries_[place_of(key, "")].set;
}

}  // namespace base
