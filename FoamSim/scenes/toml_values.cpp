#include "FoamSim/scenes/toml_values.h"

#include "Base/error.h"
#include "Base/io/file_size.h"

namespace foamsim {

std::string toml_place(const std::string& file, const toml::source_region& source) {
  return file + ":" + std::to_string(source.begin.line);
}

toml::table parse_toml(const std::string& file, const std::string& what) {
  base::require_text_file(file, what);
  try {
    return toml::parse_file(file);
  } catch (const toml::parse_error& error) {
    throw base::InputError(toml_place(file, error.source()) + ": not valid TOML: " + std::string(error.description()));
  }
}

base::OptionValue to_option_value(const toml::node& node, const std::string& where) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* whole = node.as_integer()) return static_cast<long>(whole->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* word = node.as_string()) return word->get();
  if (const auto* list = node.as_array()) {
    std::vector<std::string> words;
    for (const toml::node& item : *list) {
      if (!item.is_string() && !item.is_number())
        throw base::InputError(where + ": a list here has to hold words in quotes, or numbers");
      words.push_back(item.is_string() ? item.as_string()->get() : base::to_text(to_option_value(item, where)));
    }
    return words;
  }
  throw base::InputError(where + ": dates and nested lists are not options");
}

}  // namespace foamsim
