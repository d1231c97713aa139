#include "LosTopos/io/surface_checks.h"

#include <algorithm>

#include "Base/error.h"
#include "LosTopos/io/surface_data.h"

namespace lostopos {
namespace {

std::string count_problem(std::uint64_t count, std::uint64_t most, const char* what) {
  if (count <= most) return {};
  return std::to_string(count) + " " + what + "; at most " + std::to_string(most) + " are possible";
}

}  // namespace

std::string corner_problem(const std::array<std::int64_t, 3>& corners, std::uint64_t vertex_count,
                           std::int64_t first_number) {
  const auto count = static_cast<std::int64_t>(std::min(vertex_count, most_vertices));
  for (const std::int64_t corner : corners)
    if (corner < 0 || corner >= count)
      return "the triangle names vertex " + std::to_string(corner) + ", but " +
             (count == 0
                  ? "there are none"
                  : "they go from " + std::to_string(first_number) + " to " + std::to_string(count - 1 + first_number));
  for (int i = 0; i < 3; ++i)
    if (corners[i] == corners[(i + 1) % 3])
      return "the triangle names vertex " + std::to_string(corners[i] + first_number) +
             " twice; its three corners have to differ";
  return {};
}

std::string label_problem(std::int64_t p, std::int64_t q) {
  const bool in_range = p >= 0 && q >= 0 && p <= largest_region && q <= largest_region;
  if (in_range && p != q) return {};
  return "the triangle's labels are (" + std::to_string(p) + ", " + std::to_string(q) + "); " +
         (in_range ? "a film separates two different regions"
                   : "regions go from 0, the air, to " + std::to_string(largest_region));
}

std::string vertex_count_problem(std::uint64_t count) {
  return count_problem(count, most_vertices, "vertices");
}
std::string triangle_count_problem(std::uint64_t count) {
  return count_problem(count, most_triangles, "triangles");
}

std::array<std::uint32_t, 3> checked_corners(const std::array<std::int64_t, 3>& corners) {
  return {static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
          static_cast<std::uint32_t>(corners[2])};
}

Labels checked_labels(std::int64_t p, std::int64_t q) {
  return {Region{static_cast<std::size_t>(p)}, Region{static_cast<std::size_t>(q)}};
}

void require_edges_in_range(const SurfaceData& data, const std::string& place) {
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    const auto& corners = data.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string problem = edge_problem(data.positions[corners[i]], data.positions[corners[(i + 1) % 3]]);
      if (!problem.empty())
        throw base::InputError(
            (place.empty() ? "" : place + ": ").append("triangle " + std::to_string(t)).append(": ").append(problem));
    }
  }
}

}  // namespace lostopos
