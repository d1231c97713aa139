#pragma once

// Heavy: only sources that read TOML include it.
#include <toml++/toml.h>

#include <functional>
#include <string>

#include "Base/options/option_value.h"

namespace foamsim {

/// "FILE:LINE", where messages say that something is.
std::string toml_place(const std::string& file, const toml::source_region& source);

/// Reads a file. Throws base::FileError where it is not there (`what`: "scene file"), base::InputError with file and
/// line for what is no TOML, and for a line with more dots than a key has parts.
toml::table parse_toml(const std::string& file, const std::string& what);

/// Hands every value to `visit`, with its whole name: those of a table, and of tables within it, in the table's order,
/// or `node` itself where it is none. Throws base::InputError where tables are nested deeper than any option's name.
void visit_values(const toml::node& node, const std::string& name, const std::string& file,
                  const std::function<void(const std::string& name, const toml::node& value)>& visit);

/// The value of an option as a file gives it; lists may hold numbers for words. Throws base::InputError that begins
/// with `where` for dates and nested lists.
base::OptionValue to_option_value(const toml::node& node, const std::string& where);

}  // namespace foamsim
