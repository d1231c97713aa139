#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "Base/options/option_spec.h"

namespace base {

/// Something that users choose by name: how it is made, and the options that only it reads.
template <class Product, class Setup>
struct Model {
  std::string name;
  std::string summary;              ///< one line
  std::vector<OptionSpec> options;  ///< its own; their owner is set by the registry
  std::function<std::unique_ptr<Product>(const Setup&)> make;
};

/// The models of one kind, in the order in which they were added. A plain value: a program takes the built-in one, adds
/// its own, and passes it on; nothing is registered behind anybody's back.
template <class Entry>
class Registry {
 public:
  using value_type = Entry;

  /// `kind`: what the entries are, for messages ("effect"). Throws InputError as `add` does.
  explicit Registry(std::string kind, std::vector<Entry> entries = {}) : kind_(std::move(kind)) {
    for (Entry& entry : entries) add(std::move(entry));
  }

  /// Adds an entry behind the others and makes it the owner of its options. Throws InputError for a name that is empty
  /// or taken.
  void add(Entry entry) {
    if (entry.name.empty()) throw InputError("a new " + kind_ + " needs a name");
    if (has(entry.name)) throw InputError("there is already a " + kind_ + " called '" + entry.name + "'");
    for (OptionSpec& spec : entry.options) spec.owner = {kind_, entry.name};
    entries_.push_back(std::move(entry));
  }
  bool has(std::string_view name) const { return std::ranges::find(entries_, name, &Entry::name) != entries_.end(); }
  /// Throws InputError with the nearest name.
  const Entry& find(std::string_view name) const { return find_by_name(entries_, name, kind_); }

  const std::string& kind() const { return kind_; }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_) names.push_back(entry.name);
    return names;
  }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }
  std::size_t size() const { return entries_.size(); }

 private:
  std::string kind_;
  std::vector<Entry> entries_;
};

/// An option that holds the name of an entry, or (default_value a list) names of entries.
template <class Entry>
OptionSpec name_of(std::string key, OptionValue default_value, std::string summary, const Registry<Entry>& registry) {
  return word_from(std::move(key), std::move(default_value), std::move(summary), registry.kind(), registry.names());
}

}  // namespace base
