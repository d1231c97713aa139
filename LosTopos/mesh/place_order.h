#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Sorts slots by `key_of(slot)`, those with the same key by themselves.
template <class KeyOf>
void sort_slots(std::vector<std::uint32_t>& slots, const KeyOf& key_of) {
  std::vector<std::pair<decltype(key_of(0U)), std::uint32_t>> keyed;
  keyed.reserve(slots.size());
  for (std::uint32_t slot : slots) keyed.emplace_back(key_of(slot), slot);
  std::ranges::sort(keyed);
  std::ranges::transform(keyed, slots.begin(), [](const auto& pair) { return pair.second; });
}

/// Sorts slots of vertices along the curve through `positions` (L, by slot) that visits each octant of a cube wholly
/// before the next: what is near in space is near in the list, mostly (Morton 1966, "A computer oriented geodetic data
/// base and a new technique in file sequencing").
void sort_by_place(std::vector<std::uint32_t>& slots, std::span<const Vec3> positions);

/// Whether many triangles are far from their vertices in memory, as they are in the long run where slots that are free
/// are used again wherever the surface changes. It depends on nothing but the handles.
bool is_scattered(const SurfaceMesh& mesh);

}  // namespace lostopos
