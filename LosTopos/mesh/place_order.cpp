#include "LosTopos/mesh/place_order.h"

#include <algorithm>
#include <cmath>

namespace lostopos {
namespace {

constexpr int bits_of_axis = 21;

// Puts two zeros behind each of the lowest 21 bits.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

// Of a point in the unit cube.
std::uint64_t place_on_curve(const Vec3& x) {
  constexpr double largest = (1 << bits_of_axis) - 1;
  const auto cell = [&x](int i) { return static_cast<std::uint64_t>(std::clamp(x[i], 0.0, 1.0) * largest); };
  return spread(cell(0)) | spread(cell(1)) << 1U | spread(cell(2)) << 2U;
}

}  // namespace

void sort_by_place(std::vector<std::uint32_t>& slots, std::span<const Vec3> positions) {
  if (slots.empty()) return;
  Vec3 low = positions[slots[0]], high = low;
  for (std::uint32_t slot : slots) {
    low = low.cwiseMin(positions[slot]);
    high = high.cwiseMax(positions[slot]);
  }
  const double extent = (high - low).maxCoeff();
  if (!(extent > 0)) return;
  sort_slots(slots, [&](std::uint32_t slot) { return place_on_curve((positions[slot] - low) / extent); });
}

bool is_scattered(const SurfaceMesh& mesh) {
  constexpr double far = 0.1, many = 0.25;  // over all slots, and over all triangles
  const auto vertices = static_cast<double>(mesh.vertex_slots()),
             triangles = static_cast<double>(mesh.triangle_slots());
  std::size_t count = 0;
  for (Triangle t : mesh.triangles()) {
    const double own = static_cast<double>(t.index()) / triangles;
    const double first = static_cast<double>(std::ranges::min(mesh.vertices(t)).index()) / vertices;
    if (std::abs(own - first) > far) ++count;
  }
  return static_cast<double>(count) > many * static_cast<double>(mesh.triangle_count());
}

}  // namespace lostopos
