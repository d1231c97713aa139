#pragma once

#include <functional>
#include <string>
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
  std::string effect = {};  ///< the part of the program that reads it, when it is not the scene itself
  std::vector<std::string> words = {};  ///< not empty: the words that are allowed
};

/// A finite number > 0 / ≥ 0, and a whole number ≥ least, as specs.
OptionSpec positive_number(std::string key, double default_value, std::string summary);
OptionSpec non_negative_number(std::string key, double default_value, std::string summary);
OptionSpec whole_number(std::string key, long default_value, long least, std::string summary);
OptionSpec flag(std::string key, bool default_value, std::string summary);

}  // namespace base
