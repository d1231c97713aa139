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

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string_view> known) {
  // Beyond half of the letters wrong a suggestion would be a guess.
  std::size_t best = std::max<std::size_t>(2, name.size() / 2) + 1;
  std::string_view nearest;
  for (std::string_view candidate : known)
    if (const std::size_t distance = edit_distance(name, candidate); distance < best) {
      best = distance;
      nearest = candidate;
    }
  return std::string(nearest);
}

std::string unknown_name_message(std::string_view kind, std::string_view name,
                                 std::span<const std::string_view> known) {
  std::string message = "unknown " + std::string(kind) + " '" + std::string(name) + "'";
  if (const std::string nearest = nearest_name(name, known); !nearest.empty())
    message += "; did you mean '" + nearest + "'?";
  message += " (known:";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i == 0 ? " " : ", ") + std::string(known[i]);
  return message + ")";
}

}  // namespace base
