#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "Base/options/option_value.h"

namespace base {

/// An option that a scene file or `--set` can give: its key, default, meaning, and what is allowed.
struct OptionSpec {
  std::string key;
  OptionValue default_value;
  std::string summary;  ///< one line, with the unit
  std::string allowed;  ///< what would be right, for the message when `accepts` says no
  std::function<bool(const OptionValue&)> accepts = {};  ///< empty: everything of the kind (numbers must be finite)
  /// Who reads it: the kind and the name of a model (see Registry). Empty: every scene.
  struct Owner {
    std::string kind, name;
    bool operator==(const Owner&) const = default;
  } owner = {};
  /// Not empty: the words that are allowed, and what they are names of, for messages.
  std::vector<std::string> words = {};
  std::string words_are = {};
  /// Words that stand for numbers which nobody can give as such: {"auto", 0}, say, where numbers have to be > 0.
  std::vector<std::pair<std::string, double>> named_numbers = {};
};

/// `value` of this option as written in a scene file.
std::string to_text(const OptionSpec& spec, const OptionValue& value);
/// The number that a word stands for with this option; null: none.
const double* find_named_number(const OptionSpec& spec, std::string_view word);

/// A finite number > 0 / ≥ 0, and a whole number ≥ least / from least to most, as specs. Whatever says how much of
/// something there is to be needs a most.
OptionSpec positive_number(std::string key, double default_value, std::string summary);
OptionSpec non_negative_number(std::string key, double default_value, std::string summary);
OptionSpec whole_number(std::string key, long default_value, long least, std::string summary);
OptionSpec whole_between(long least, long most, long default_value, std::string key, std::string summary);
OptionSpec flag(std::string key, bool default_value, std::string summary);
/// One of some words, or a list of them where the default is a list; `kind`: what they are names of.
OptionSpec word_from(std::string key, OptionValue default_value, std::string summary, std::string kind,
                     std::vector<std::string> words);

}  // namespace base
