#include <algorithm>
#include <map>
#include <optional>

#include "LosTopos/io/repair/repairs.h"
#include "LosTopos/io/surface_edit.h"

namespace lostopos {
namespace {

// Whether the two name the same corners in the same sense of rotation.
bool same_winding(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  for (std::size_t turn = 0; turn < 3; ++turn)
    if (a[0] == b[turn] && a[1] == b[(turn + 1) % 3]) return true;
  return false;
}

// The regions on both sides of two films on each other, from labels in the same sense; equal ones: of none. Nothing
// where the two do not go together.
std::optional<Labels> of_both(const Labels& a, const Labels& b) {
  if (a == b) return a;
  if (a.q == b.p) return Labels{a.p, b.q};
  if (b.q == a.p) return Labels{b.p, a.q};
  return std::nullopt;
}

}  // namespace

std::size_t merge_repeated_triangles(SurfaceData& data) {
  std::map<std::array<std::uint32_t, 3>, std::size_t> first;  // by sorted corners
  std::vector<bool> gone(data.triangles.size(), false);
  std::size_t merged = 0;
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> key = data.triangles[t];
    std::ranges::sort(key);
    const auto [place, is_new] = first.emplace(key, t);
    if (is_new) continue;
    const std::size_t other = place->second;
    const bool same = same_winding(data.triangles[other], data.triangles[t]);
    const auto both = of_both(data.labels[other], same ? data.labels[t] : data.labels[t].flipped());
    if (!both) continue;
    gone[t] = true;
    ++merged;
    if (both->p != both->q) {
      data.labels[other] = *both;
    } else {
      gone[other] = true;
      ++merged;
      first.erase(place);
    }
  }
  if (merged == 0) return 0;
  std::vector<std::array<std::uint32_t, 3>> kept;
  std::vector<std::size_t> parents;
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    if (gone[t]) continue;
    kept.push_back(data.triangles[t]);
    parents.push_back(t);
  }
  replace_triangles(data, std::move(kept), parents);
  return merged;
}

}  // namespace lostopos
