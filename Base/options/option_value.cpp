#include "Base/options/option_value.h"

#include <charconv>
#include <limits>

#include "Base/error.h"

namespace base {
namespace {

[[noreturn]] void throw_mismatch(const std::string& text, const OptionValue& like) {
  throw InputError("'" + text + "' is not " + std::string(kind_of(like)));
}

template <class Number>
Number parse_number(std::string_view text, const OptionValue& like) {
  Number number{};
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) throw_mismatch(std::string(text), like);
  return number;
}

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> parse_list(std::string_view text) {
  if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
  std::vector<std::string> words;
  while (!trim(text).empty()) {
    const auto comma = text.find(',');
    std::string_view word = trim(text.substr(0, comma));
    if (word.size() >= 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
    words.emplace_back(word);
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return words;
}

std::string number_text(double number) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), number);
  return {buffer, end};
}

}  // namespace

std::string_view kind_of(const OptionValue& value) {
  constexpr std::string_view kinds[] = {"true or false", "a whole number", "a number", "a word", "a list of words"};
  return kinds[value.index()];
}

std::string to_text(const OptionValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<long>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  std::string text;
  for (const std::string& word : std::get<Words>(value)) text += (text.empty() ? "" : ",") + word;
  return text;
}

OptionValue parse_option(std::string_view text, const OptionValue& like) {
  text = trim(text);
  if (std::holds_alternative<bool>(like)) {
    if (text == "true" || text == "1" || text == "on" || text == "yes") return true;
    if (text == "false" || text == "0" || text == "off" || text == "no") return false;
    throw_mismatch(std::string(text), like);
  }
  if (std::holds_alternative<long>(like)) return parse_number<long>(text, like);
  if (std::holds_alternative<double>(like)) return parse_number<double>(text, like);
  if (std::holds_alternative<std::string>(like)) return std::string(text);
  return parse_list(text);
}

OptionValue convert_option(const OptionValue& value, const OptionValue& like) {
  if (value.index() == like.index()) return value;
  if (std::holds_alternative<double>(like) && std::holds_alternative<long>(value))
    return static_cast<double>(std::get<long>(value));
  if (std::holds_alternative<Words>(like) && std::holds_alternative<std::string>(value))
    return parse_list(std::get<std::string>(value));
  throw_mismatch(to_text(value), like);
}

}  // namespace base
