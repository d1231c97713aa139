#pragma once

// Heavy: only sources that read TOML include it.
#include <toml++/toml.h>

#include <string>

#include "Base/options/option_value.h"

namespace foamsim {

/// "FILE:LINE", where messages say that something is.
std::string toml_place(const std::string& file, const toml::source_region& source);

/// Reads a file. Throws base::FileError where it is not there (`what`: "scene file"), base::InputError with file and
/// line for what is no TOML.
toml::table parse_toml(const std::string& file, const std::string& what);

/// The value of an option as a file gives it; lists may hold numbers for words. Throws base::InputError that begins
/// with `where` for dates and nested lists.
base::OptionValue to_option_value(const toml::node& node, const std::string& where);

}  // namespace foamsim
