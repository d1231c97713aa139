#include "Base/io/number_text.h"

#include <array>
#include <charconv>

namespace base {
namespace {

template <class T>
void append(std::string& text, T value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

template <class T>
std::optional<T> parse(std::string_view token) {
  // from_chars knows no leading plus; "+-1" must not slip through.
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  T value{};
  const char* end = token.data() + token.size();
  const auto result = std::from_chars(token.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

void append_number(std::string& text, double value) {
  append(text, value);
}
void append_number(std::string& text, std::int64_t value) {
  append(text, value);
}

std::optional<double> parse_double(std::string_view token) {
  return parse<double>(token);
}
std::optional<std::int64_t> parse_integer(std::string_view token) {
  return parse<std::int64_t>(token);
}

}  // namespace base
