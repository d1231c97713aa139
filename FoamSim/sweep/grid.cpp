#include "FoamSim/sweep/grid.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/toml_values.h"
#include "FoamSim/sweep/plan.h"
#include "FoamSim/sweep/stable_hash.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

// An entry of a table, with the whole key.
struct Entry {
  std::string key;
  const toml::node* node;
};

// All entries, those of tables within it included, in the order of the file: a toml::table is sorted by key.
std::vector<Entry> entries_of(const toml::table& table, const std::string& file) {
  std::vector<Entry> entries;
  for (const auto& [key, node] : table)
    visit_values(node, std::string(key.str()), file, [&](const std::string& name, const toml::node& value) {
      entries.push_back({name, &value});
    });
  std::ranges::stable_sort(entries, [](const Entry& a, const Entry& b) {
    const auto& [x, y] = std::pair(a.node->source().begin, b.node->source().begin);
    return std::pair(x.line, x.column) < std::pair(y.line, y.column);
  });
  return entries;
}

// The option's value as --set takes it, once the set has accepted it.
std::string accepted_text(base::OptionSet options, const Entry& entry, const toml::node& node,
                          const std::string& where) {
  options.set(entry.key, to_option_value(node, where), where);
  const auto spec = std::ranges::find(options.specs(), entry.key, &base::OptionSpec::key);
  const base::OptionValue& value = options.value(entry.key);
  std::string text = base::to_text(*spec, value);
  // A text goes through the command line of `run`, where commas separate words and blanks at the ends are dropped.
  base::OptionSet again = options;
  again.set_text(entry.key, text, where);
  if (again.value(entry.key) != value)
    throw base::InputError(where + ": '" + text +
                           "' cannot be given on a command line (commas, blanks at an end); put it into a scene file");
  return text;
}

std::string value_twice(const std::string& where, const std::string& key, const std::string& value) {
  return where + ": " + key + " has the value " + value + " twice";
}

class GridReader {
 public:
  GridReader(const std::string& file, std::shared_ptr<const Catalogue> catalogue)
      : file_(file), catalogue_(std::move(catalogue)), table_(parse_toml(file, "grid file")) {}

  Grid read() {
    for (const auto& [key, node] : table_) require_known(std::string(key.str()), node);
    Scene scene = read_scene();
    read_stop();
    if (const toml::table* options = table_named("options"))
      for (const Entry& entry : entries_of(*options, file_)) {
        const std::string where = place_of(*entry.node);
        grid_.fixed.push_back(entry.key + "=" + accepted_text(scene.options, entry, *entry.node, where));
        scene.options.set(entry.key, to_option_value(*entry.node, where), where);
      }
    const toml::table* sweep = table_named("sweep");
    if (sweep == nullptr || sweep->empty())
      throw base::InputError(file_ +
                             ": a grid needs a table [sweep] with a list of values for each option that varies");
    for (const Entry& entry : entries_of(*sweep, file_)) grid_.axes.push_back(read_axis(entry, scene.options));
    return std::move(grid_);
  }

 private:
  std::string place_of(const toml::node& node) const { return toml_place(file_, node.source()); }

  void require_known(const std::string& key, const toml::node& node) const {
    constexpr std::array<std::string_view, 6> known{"scene", "time", "steps", "until_rest", "options", "sweep"};
    if (std::ranges::find(known, key) == known.end())
      throw base::InputError(place_of(node) + ": " + base::unknown_name_message("key of a grid", key, known) +
                             "; options go into [options] or [sweep]");
  }

  const toml::table* table_named(const char* name) const {
    const toml::node* node = table_.get(name);
    if (node != nullptr && node->as_table() == nullptr)
      throw base::InputError(place_of(*node) + ": '" + name + "' is a table: begin it with [" + name + "]");
    return node == nullptr ? nullptr : node->as_table();
  }

  Scene read_scene() {
    const toml::node* node = table_.get("scene");
    if (node == nullptr || !node->is_string())
      throw base::InputError((node == nullptr ? file_ : place_of(*node)) +
                             ": a grid needs scene = \"NAME\", a built-in scene or a file as 'run' takes it");
    grid_.scene = node->as_string()->get();
    if (fs::path(grid_.scene).has_extension())
      grid_.scene = fs::absolute(fs::path(file_).parent_path() / grid_.scene).lexically_normal().string();
    try {
      Scene scene = load_scene(grid_.scene, catalogue_);
      if (fs::is_regular_file(grid_.scene)) {
        std::ifstream in(grid_.scene, std::ios::binary);
        grid_.scene_hash = stable_hash(std::string(std::istreambuf_iterator<char>(in), {}));
      }
      return scene;
    } catch (const base::InputError& error) {
      throw base::InputError(place_of(*node) + ": " + error.what());
    }
  }

  void read_stop() {
    if (const toml::node* node = table_.get("time")) {
      grid_.time = node->value<double>();
      if (!grid_.time || !std::isfinite(*grid_.time) || *grid_.time < 0)
        throw base::InputError(place_of(*node) + ": 'time' has to be a finite number >= 0");
    }
    if (const toml::node* node = table_.get("steps")) {
      if (node->is_integer()) grid_.steps = static_cast<long>(node->as_integer()->get());
      if (!grid_.steps || *grid_.steps < 0)
        throw base::InputError(place_of(*node) + ": 'steps' has to be a whole number >= 0");
    }
    if (const toml::node* node = table_.get("until_rest")) {
      if (!node->is_boolean()) throw base::InputError(place_of(*node) + ": 'until_rest' has to be true or false");
      grid_.until_rest = node->as_boolean()->get();
    }
  }

  Axis read_axis(const Entry& entry, const base::OptionSet& options) const {
    const std::string where = place_of(*entry.node);
    const toml::array* list = entry.node->as_array();
    if (list == nullptr)
      throw base::InputError(where + ": " + entry.key +
                             " needs a list of values, [a, b]; an option with one value goes into [options]");
    if (list->empty()) throw base::InputError(where + ": the list of " + entry.key + " is empty");
    if (list->size() > most_runs)
      throw base::InputError(where + ": " + entry.key + " has " + std::to_string(list->size()) +
                             " values; a sweep can have " + std::to_string(most_runs) + " runs at most");
    Axis axis{entry.key, {}};
    std::set<std::string> taken;
    for (const toml::node& item : *list) {
      const std::string place = place_of(item);
      std::string text = accepted_text(options, entry, item, place);
      if (!taken.insert(text).second) throw base::InputError(value_twice(place, entry.key, text));
      axis.values.push_back(std::move(text));
    }
    return axis;
  }

  const std::string& file_;
  std::shared_ptr<const Catalogue> catalogue_;
  toml::table table_;
  Grid grid_;
};

}  // namespace

Grid read_grid(const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  return GridReader(file, std::move(catalogue)).read();
}

std::size_t count_runs(const Grid& grid) {
  std::size_t count = 1;
  for (const Axis& axis : grid.axes) {
    if (axis.values.size() > most_runs_counted / count) return most_runs_counted;
    count *= axis.values.size();
  }
  return count;
}

json to_json(const Grid& grid) {
  json value = {{"scene", grid.scene},
                {"scene_hash", grid.scene_hash},
                {"options", grid.fixed},
                {"until_rest", grid.until_rest},
                {"sweep", json::array()}};
  if (!grid.study.empty()) value["study"] = grid.study;
  if (grid.time) value["time"] = *grid.time;
  if (grid.steps) value["steps"] = *grid.steps;
  for (const Axis& axis : grid.axes) value["sweep"].push_back({{"option", axis.key}, {"values", axis.values}});
  return value;
}

Grid grid_from_json(const json& value) {
  Grid grid;
  grid.scene = value.at("scene").get<std::string>();
  grid.scene_hash = value.at("scene_hash").get<std::string>();
  grid.fixed = value.at("options").get<std::vector<std::string>>();
  grid.until_rest = value.at("until_rest").get<bool>();
  if (value.contains("study")) grid.study = value["study"].get<std::string>();
  if (value.contains("time")) grid.time = value["time"].get<double>();
  if (value.contains("steps")) grid.steps = value["steps"].get<long>();
  for (const json& axis : value.at("sweep"))
    grid.axes.push_back({axis.at("option").get<std::string>(), axis.at("values").get<std::vector<std::string>>()});
  return grid;
}

}  // namespace foamsim::sweep
