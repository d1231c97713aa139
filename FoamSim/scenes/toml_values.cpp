#include "FoamSim/scenes/toml_values.h"

#include <algorithm>
#include <fstream>

#include "Base/error.h"
#include "Base/io/file_size.h"

namespace foamsim {

namespace {

// The parser makes a table for every part of a dotted key and takes them down again one within the other, on the stack:
// some 100,000 of them end the program. Within a value, at most 256 deep, keys may have dots again.
void require_short_keys(const std::string& file) {
  constexpr std::ptrdiff_t most_dots = 255;
  std::ifstream in(file, std::ios::binary);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number)
    if (std::ranges::count(line, '.') > most_dots)
      throw base::InputError(file + ":" + std::to_string(number) + ": more than " + std::to_string(most_dots) +
                             " dots in one line; no key has as many parts, and a long list can take several lines");
}

void visit_values(const toml::node& node, const std::string& name, const std::string& file, int depth,
                  const std::function<void(const std::string&, const toml::node&)>& visit) {
  constexpr int deepest = 8;
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    visit(name, node);
    return;
  }
  if (depth == deepest)
    throw base::InputError(toml_place(file, node.source()) + ": tables are nested more than " +
                           std::to_string(deepest) + " deep; no option has such a name");
  for (const auto& [key, value] : *table)
    visit_values(value, name + "." + std::string(key.str()), file, depth + 1, visit);
}

}  // namespace

std::string toml_place(const std::string& file, const toml::source_region& source) {
  return file + ":" + std::to_string(source.begin.line);
}

toml::table parse_toml(const std::string& file, const std::string& what) {
  base::require_text_file(file, what);
  require_short_keys(file);
  try {
    return toml::parse_file(file);
  } catch (const toml::parse_error& error) {
    throw base::InputError(toml_place(file, error.source()) + ": not valid TOML: " + std::string(error.description()));
  }
}

void visit_values(const toml::node& node, const std::string& name, const std::string& file,
                  const std::function<void(const std::string&, const toml::node&)>& visit) {
  visit_values(node, name, file, 0, visit);
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
