#include "FoamSim/scenes/toml_scene.h"

#include <toml++/toml.h>

#include <filesystem>
#include <sstream>

#include "Base/error.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim {

namespace {

std::string place(const std::string& file, const toml::source_region& source) {
  return file + ":" + std::to_string(source.begin.line);
}

base::OptionValue to_option_value(const toml::node& node, const std::string& where) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* whole = node.as_integer()) return static_cast<long>(whole->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* word = node.as_string()) return word->get();
  if (const auto* list = node.as_array()) {
    std::vector<std::string> words;
    for (const toml::node& item : *list) {
      if (!item.is_string()) throw base::InputError(where + ": a list here has to hold words in quotes");
      words.push_back(item.as_string()->get());
    }
    return words;
  }
  throw base::InputError(where + ": dates and nested lists are not options");
}

void read_table(const toml::table& table, const std::string& prefix, const std::string& file,
                base::OptionSet& options) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (prefix.empty() && (name == "scene" || name == "mesh")) continue;
    if (const auto* inner = node.as_table()) {
      read_table(*inner, name + ".", file, options);
      continue;
    }
    const std::string where = place(file, node.source());
    options.set(name, to_option_value(node, where), where);
  }
}

Scene start_of(const toml::table& table, const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  const toml::node* scene = table.get("scene");
  const toml::node* mesh = table.get("mesh");
  if ((scene == nullptr) == (mesh == nullptr))
    throw base::InputError(file + ": a scene file needs either scene = \"NAME\" or mesh = \"FILE\"");
  const toml::node& start = scene != nullptr ? *scene : *mesh;
  const std::string where = place(file, start.source());
  if (!start.is_string()) throw base::InputError(where + ": a name in quotes has to follow here");
  const std::string name = start.as_string()->get();
  if (mesh != nullptr) {
    if (lostopos::find_mesh_format(name) == nullptr)
      throw base::InputError(where + ": '" + name + "' is not a mesh file; known are " + lostopos::mesh_extensions());
    return mesh_scene((std::filesystem::path(file).parent_path() / name).string(), std::move(catalogue));
  }
  try {
    return built_in_scene(name, std::move(catalogue));
  } catch (const base::InputError& error) {
    throw base::InputError(where + ": " + error.what());
  }
}

}  // namespace

Scene read_toml_scene(const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  if (!std::filesystem::is_regular_file(file)) throw base::FileError(file + ": there is no such scene file");
  toml::table table;
  try {
    table = toml::parse_file(file);
  } catch (const toml::parse_error& error) {
    throw base::InputError(place(file, error.source()) + ": not valid TOML: " + std::string(error.description()));
  }
  Scene scene = start_of(table, file, std::move(catalogue));
  read_table(table, "", file, scene.options);
  return scene;
}

}  // namespace foamsim
