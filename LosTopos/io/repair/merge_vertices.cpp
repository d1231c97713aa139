#include <algorithm>
#include <array>
#include <cmath>

#include "Base/lists/equal_entries.h"
#include "LosTopos/io/repair/repairs.h"
#include "LosTopos/io/surface_edit.h"

namespace lostopos {
namespace {

using Cell = std::array<std::int64_t, 3>;

// Vertices by the cell of a grid that they are in: those near a place are found in a few cells.
class VertexGrid {
 public:
  VertexGrid(const std::vector<Vec3>& positions, double distance) : positions_(positions), distance_(distance) {
    low_ = positions.front();
    for (const Vec3& x : positions) low_ = low_.cwiseMin(x);
    for (std::uint32_t v = 0; v < positions.size(); ++v) entries_.push_back({cell_of(positions[v]), v});
    std::ranges::sort(entries_, {}, [](const Entry& entry) { return std::pair(entry.cell, entry.vertex); });
  }

  /// Calls `visit` with every vertex within the distance of v.
  template <class Visit>
  void near(std::uint32_t v, const Visit& visit) const {
    const Vec3 reach = Vec3::Constant(distance_);
    const Cell from = cell_of(positions_[v] - reach), to = cell_of(positions_[v] + reach);
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z)
          for (const Entry& entry : base::equal_entries(entries_, Cell{x, y, z}, &Entry::cell))
            if ((positions_[entry.vertex] - positions_[v]).norm() <= distance_) visit(entry.vertex);
  }

 private:
  struct Entry {
    Cell cell;
    std::uint32_t vertex;
  };
  // So large that most places need a look at one cell only.
  static constexpr double cell_over_distance = 8;

  Cell cell_of(const Vec3& x) const {
    Cell cell{};
    if (!(distance_ > 0)) return cell;
    for (int i = 0; i < 3; ++i)
      cell[static_cast<std::size_t>(i)] =
          static_cast<std::int64_t>(std::floor((x[i] - low_[i]) / (cell_over_distance * distance_)));
    return cell;
  }

  const std::vector<Vec3>& positions_;
  double distance_;
  Vec3 low_;
  std::vector<Entry> entries_;
};

}  // namespace

std::size_t merge_vertices(SurfaceData& data, double distance) {
  if (data.positions.empty() || !(distance > 0)) return 0;
  const VertexGrid grid(data.positions, distance);
  std::vector<std::uint32_t> same_as(data.positions.size());
  for (std::uint32_t v = 0; v < same_as.size(); ++v) {
    same_as[v] = v;
    grid.near(v, [&](std::uint32_t other) {
      if (other < same_as[v] && same_as[other] == other) same_as[v] = other;
    });
  }
  std::vector<std::uint32_t> numbers(same_as.size());
  std::uint32_t next = 0;
  for (std::uint32_t v = 0; v < numbers.size(); ++v) numbers[v] = same_as[v] == v ? next++ : numbers[same_as[v]];
  const std::size_t merged = numbers.size() - next;
  if (merged > 0) renumber_vertices(data, numbers);
  return merged;
}

std::size_t drop_collapsed_triangles(SurfaceData& data) {
  std::vector<std::array<std::uint32_t, 3>> kept;
  std::vector<std::size_t> parents;
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    const auto& [a, b, c] = data.triangles[t];
    if (a == b || b == c || c == a) continue;
    kept.push_back(data.triangles[t]);
    parents.push_back(t);
  }
  const std::size_t dropped = data.triangles.size() - kept.size();
  if (dropped > 0) replace_triangles(data, std::move(kept), parents);
  return dropped;
}

}  // namespace lostopos
