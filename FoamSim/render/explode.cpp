#include "FoamSim/render/explode.h"

#include <map>
#include <utility>

#include "Base/error.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

// Mean of corners, each as often as a triangle has it.
struct Middle {
  Vector3d sum = Vector3d::Zero();
  double count = 0;

  void add(const Vector3d& x) {
    sum += x;
    ++count;
  }
  Vector3d value() const { return count > 0 ? Vector3d(sum / count) : Vector3d::Zero(); }
};

bool shown(const Surface& surface, std::size_t t) {
  return surface.hidden.empty() || surface.hidden[t] == 0;
}

}  // namespace

Surface explode(const Surface& surface, double factor) {
  if (!(factor >= 0 && factor <= 100)) throw base::InputError("explode: the factor has to be from 0 to 100");
  std::map<std::int32_t, Middle> bubbles;
  Middle all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t]) {
      if (!shown(surface, t)) continue;
      all.add(surface.positions[v]);
      for (const std::int32_t region : surface.labels[t])
        if (region != 0) bubbles[region].add(surface.positions[v]);
    }
  if (bubbles.empty()) throw base::InputError("explode: the surface has no bubbles");

  Surface out;
  std::map<std::pair<std::int32_t, std::uint32_t>, std::uint32_t> copies;
  const auto copy = [&](std::int32_t region, std::uint32_t v) {
    const auto [place, is_new] = copies.try_emplace({region, v}, static_cast<std::uint32_t>(out.positions.size()));
    if (is_new) out.positions.push_back(surface.positions[v] + factor * (bubbles.at(region).value() - all.value()));
    return place->second;
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!shown(surface, t)) continue;
    const auto& [a, b, c] = surface.triangles[t];
    for (const std::int32_t region : surface.labels[t]) {
      if (region == 0) continue;
      out.triangles.push_back({copy(region, a), copy(region, b), copy(region, c)});
      out.labels.push_back(surface.labels[t]);
      if (!surface.colors.empty()) out.colors.push_back(surface.colors[t]);
    }
  }
  return out;
}

}  // namespace foamsim::render
