#include "Base/names/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace base {
namespace {

// Levenshtein distance, case ignored.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replace = diagonal + (same(a[i], b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// For "group.name" also the distance to "name" alone.
std::size_t name_distance(std::string_view name, std::string_view candidate) {
  const std::size_t whole = edit_distance(name, candidate), dot = candidate.rfind('.');
  return dot == std::string_view::npos ? whole : std::min(whole, edit_distance(name, candidate.substr(dot + 1)) + 1);
}

}  // namespace

std::vector<std::string> nearest_names(std::string_view name, std::span<const std::string_view> known,
                                       std::size_t most) {
  // Beyond half of the letters wrong a suggestion would be a guess; beside the best one, those hardly worse.
  const std::size_t limit = std::max<std::size_t>(2, name.size() / 2);
  std::vector<std::pair<std::size_t, std::string_view>> near;
  for (std::string_view candidate : known) {
    // So many letters too many cannot be few changes. To compare them would take the product of both lengths.
    if (name.size() > candidate.size() + limit) continue;
    if (const std::size_t distance = name_distance(name, candidate); distance <= limit)
      near.emplace_back(distance, candidate);
  }
  std::ranges::stable_sort(near, {}, [](const auto& entry) { return entry.first; });
  std::vector<std::string> names;
  for (const auto& [distance, candidate] : near)
    if (names.size() < most && distance <= near.front().first + 1) names.emplace_back(candidate);
  return names;
}

std::string nearest_name(std::string_view name, std::span<const std::string_view> known) {
  const std::vector<std::string> nearest = nearest_names(name, known, 1);
  return nearest.empty() ? std::string() : nearest.front();
}

std::string unknown_name_message(std::string_view kind, std::string_view name, std::span<const std::string_view> known,
                                 std::string_view listed_by) {
  constexpr std::size_t most_suggestions = 3, longest_list = 12;
  std::string message = "unknown " + std::string(kind) + " '" + std::string(name) + "'";
  const std::vector<std::string> nearest = nearest_names(name, known, most_suggestions);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const std::string_view before = i == 0 ? "; did you mean " : i + 1 < nearest.size() ? ", " : " or ";
    message += std::string(before) + "'" + nearest[i] + "'" + (i + 1 == nearest.size() ? "?" : "");
  }
  if (!listed_by.empty()) return message + " (see '" + std::string(listed_by) + "')";
  if (known.size() > longest_list) return message;
  message += " (known:";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i == 0 ? " " : ", ") + std::string(known[i]);
  return message + ")";
}

}  // namespace base
