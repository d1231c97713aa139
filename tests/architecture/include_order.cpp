#include "include_order.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace architecture {
namespace {

bool lies_in(std::string_view file, std::string_view place) {
  return file.starts_with(place) && (file.size() == place.size() || file[place.size()] == '/');
}

}  // namespace

IncludeOrder IncludeOrder::read(std::istream& lines) {
  IncludeOrder order;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string place;
    if (!(words >> place)) continue;
    if (place.ends_with(':')) place.pop_back();
    if (std::ranges::find(order.places_, place) != order.places_.end())
      throw std::runtime_error("named twice: " + line);
    std::vector<bool> sees(order.places_.size() + 1, false);
    sees.back() = true;
    for (std::string below; words >> below;) {
      bool known = false;
      for (std::size_t i = 0; i < order.places_.size(); ++i) {
        if (!lies_in(order.places_[i], below)) continue;
        known = true;
        for (std::size_t j = 0; j < order.sees_[i].size(); ++j) sees[j] = sees[j] || order.sees_[i][j];
      }
      if (!known) throw std::runtime_error(std::string(below).append(" is not above the line: ").append(line));
    }
    order.places_.push_back(place);
    order.sees_.push_back(std::move(sees));
  }
  return order;
}

std::size_t IncludeOrder::index_of(std::string_view file) const {
  std::size_t best = places_.size();
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (lies_in(file, places_[i]) && (best == places_.size() || places_[i].size() > places_[best].size())) best = i;
  return best;
}

std::string_view IncludeOrder::place_of(std::string_view file) const {
  const std::size_t i = index_of(file);
  return i == places_.size() ? std::string_view() : places_[i];
}

std::optional<std::string> IncludeOrder::objection(std::string_view source, std::string_view included) const {
  const std::string names = std::string(source) + " includes " + std::string(included) + ": ";
  const std::size_t from = index_of(source), to = index_of(included);
  if (from == places_.size()) return std::string(source) + " is in no place of the list";
  if (to == places_.size()) return names + "that is in no place of the list; includes give the path from the top";
  if (to < sees_[from].size() && sees_[from][to]) return std::nullopt;
  return names + places_[from] + " does not stand on " + places_[to];
}

std::vector<std::string> quoted_includes(std::istream& source) {
  static const std::regex include(R"(^\s*#\s*include\s*\"([^\"]+)\")");
  std::vector<std::string> names;
  std::smatch found;
  for (std::string line; std::getline(source, line);)
    if (std::regex_search(line, found, include)) names.push_back(found[1]);
  return names;
}

std::string fenced_order(std::istream& page) {
  std::string order;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (inside && line.starts_with("```")) return order;
    if (inside) order += line + "\n";
    if (line == "```order") inside = true;
  }
  throw std::runtime_error("no lines between ```order and ```");
}

}  // namespace architecture
