#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace base {

/// A list of words. A type of its own, since a std::variant of library types only destroys what it has not made yet
/// when memory ends while it is copied (libstdc++ of GCC 12: such variants are never looked on as without value).
struct Words : std::vector<std::string> {
  using std::vector<std::string>::vector;
  Words(std::vector<std::string> words) : vector(std::move(words)) {}  // NOLINT(google-explicit-constructor)
};

/// What an option can hold: a flag, a whole number, a number, a word, or a list of words.
using OptionValue = std::variant<bool, long, double, std::string, Words>;

/// "a whole number", "true or false", … : the kind of `value` for messages.
std::string_view kind_of(const OptionValue& value);
/// As written in a scene file; numbers with all their digits.
std::string to_text(const OptionValue& value);
/// Reads `text` as the kind of `like` (lists are separated by commas). Throws InputError that names the kind.
OptionValue parse_option(std::string_view text, const OptionValue& like);
/// `value` as the kind of `like`: whole numbers pass as numbers. Throws InputError for any other mismatch.
OptionValue convert_option(const OptionValue& value, const OptionValue& like);

}  // namespace base
