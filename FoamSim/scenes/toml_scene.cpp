#include "FoamSim/scenes/toml_scene.h"

#include <filesystem>

#include "Base/error.h"
#include "FoamSim/constraints/wire_spec.h"
#include "FoamSim/scenes/toml_values.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim {

namespace {

void read_options(const toml::table& table, const std::string& file, base::OptionSet& options) {
  for (const auto& [key, node] : table) {
    if (key == "scene" || key == "mesh" || key == "wire") continue;
    visit_values(node, std::string(key.str()), file, [&](const std::string& name, const toml::node& value) {
      const std::string where = toml_place(file, value.source());
      options.set(name, to_option_value(value, where), where);
    });
  }
}

// A table of a wire as the text that the option `wires` has for it.
class WireTable {
 public:
  WireTable(const toml::node& node, const std::string& file) : file_(file), where_(toml_place(file, node.source())) {
    if (node.as_table() == nullptr) fail("a wire is a table: begin it with [[wire]]");
    table_ = node.as_table();
    for (const auto& [key, value] : *table_)
      if (key != "vertices" && key != "selection" && key != "motion" && key != "from" && key != "until")
        throw base::InputError(toml_place(file_, value.source()) + ": a wire has no '" + std::string(key.str()) +
                               "'; it has vertices or selection, motion, from and until");
  }

  std::string text() const {
    std::string text = selection() + ": " + word("motion", "still");
    for (const char* time : {"from", "until"})
      if (const toml::node* node = table_->get(time)) {
        const auto number = node->value<double>();
        if (!number) fail_at(*node, std::string("'") + time + "' is a time, a number");
        text += std::string(" ") + time + " " + base::to_text(*number);
      }
    try {
      return WireSpec(text).text();
    } catch (const base::InputError& error) {
      fail(error.what());
    }
  }
  const std::string& where() const { return where_; }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw base::InputError(where_ + ": " + why); }
  [[noreturn]] void fail_at(const toml::node& node, const std::string& why) const {
    throw base::InputError(toml_place(file_, node.source()) + ": " + why);
  }
  std::string word(const char* key, const char* otherwise) const {
    const toml::node* node = table_->get(key);
    if (node == nullptr) return otherwise;
    if (!node->is_string()) fail_at(*node, std::string("'") + key + "' is a text in quotes");
    return node->as_string()->get();
  }
  std::string selection() const {
    const toml::node* vertices = table_->get("vertices");
    if ((vertices == nullptr) == (table_->get("selection") == nullptr))
      fail("a wire needs either vertices = [3, 4, 5] or selection = \"held and x < 0\"");
    if (vertices == nullptr) return word("selection", "");
    const toml::array* list = vertices->as_array();
    if (list == nullptr || list->empty()) fail_at(*vertices, "'vertices' is a list of vertex numbers, not empty");
    std::string text = "vertices";
    for (const toml::node& item : *list) {
      if (!item.is_integer()) fail_at(item, "a vertex is named by its number");
      text += " " + std::to_string(item.as_integer()->get());
    }
    return text;
  }

  const std::string& file_;
  std::string where_;
  const toml::table* table_ = nullptr;
};

void read_wires(const toml::table& table, const std::string& file, base::OptionSet& options) {
  const toml::node* node = table.get("wire");
  if (node == nullptr) return;
  const toml::array* wires = node->as_array();
  if (wires == nullptr)
    throw base::InputError(toml_place(file, node->source()) + ": wires are tables: begin each with [[wire]]");
  std::vector<std::string> texts = options.is_set("wires") ? options.words("wires") : std::vector<std::string>{};
  for (const toml::node& wire : *wires) texts.push_back(WireTable(wire, file).text());
  options.set("wires", texts, toml_place(file, node->source()));
  if (!options.is_set("constraints"))
    options.set("constraints", std::vector<std::string>{"wire"}, toml_place(file, node->source()));
}

Scene start_of(const toml::table& table, const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  const toml::node* scene = table.get("scene");
  const toml::node* mesh = table.get("mesh");
  if ((scene == nullptr) == (mesh == nullptr))
    throw base::InputError(file + ": a scene file needs either scene = \"NAME\" or mesh = \"FILE\"");
  const toml::node& start = scene != nullptr ? *scene : *mesh;
  const std::string where = toml_place(file, start.source());
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
  const toml::table table = parse_toml(file, "scene file");
  Scene scene = start_of(table, file, std::move(catalogue));
  read_options(table, file, scene.options);
  read_wires(table, file, scene.options);
  return scene;
}

}  // namespace foamsim
