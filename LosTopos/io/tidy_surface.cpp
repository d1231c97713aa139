#include "LosTopos/io/tidy_surface.h"

#include <algorithm>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_lines.h"

namespace lostopos {
namespace {

constexpr std::uint32_t dropped = Vertex::invalid_index;

// The new number of each vertex, or `dropped`.
std::vector<std::uint32_t> numbers_of_used_vertices(const SurfaceData& data) {
  std::vector<std::uint32_t> numbers(data.positions.size(), dropped);
  for (const auto& triangle : data.triangles)
    for (const std::uint32_t corner : triangle) numbers[corner] = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& number : numbers)
    if (number != dropped) number = next++;
  return numbers;
}

// Leaves the entries of used vertices, `width` values each.
template <class T>
void keep_used(const std::vector<std::uint32_t>& numbers, std::vector<T>& values, std::size_t width = 1) {
  std::vector<T> kept;
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] != dropped)
      for (std::size_t i = 0; i < width; ++i) kept.push_back(values[v * width + i]);
  values = std::move(kept);
}

void keep_used_pairs(const std::vector<std::uint32_t>& numbers, PairArray& array) {
  PairArray kept{array.name, {0}, {}};
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == dropped) continue;
    kept.values.insert(kept.values.end(), array.at(v).begin(), array.at(v).end());
    kept.offsets.push_back(kept.values.size());
  }
  array = std::move(kept);
}

std::size_t drop_unused_vertices(SurfaceData& data) {
  const std::vector<std::uint32_t> numbers = numbers_of_used_vertices(data);
  const std::size_t before = data.positions.size();
  const auto unused = static_cast<std::size_t>(std::ranges::count(numbers, dropped));
  if (unused == 0 || unused == before) return 0;
  keep_used(numbers, data.positions);
  for (PairArray& array : data.pair_arrays) keep_used_pairs(numbers, array);
  for (DataArray& array : data.vertex_arrays)
    keep_used(numbers, array.values, static_cast<std::size_t>(array.components));
  for (auto& triangle : data.triangles)
    for (std::uint32_t& corner : triangle) corner = numbers[corner];
  std::erase_if(data.held, [&](const HeldVertex& held) { return numbers[held.vertex] == dropped; });
  for (HeldVertex& held : data.held) held.vertex = numbers[held.vertex];
  return unused;
}

bool is_consistent(const SurfaceData& data) {
  const SurfaceMesh mesh = to_mesh(data);
  const auto report = audit(mesh, {.intersections = false, .closed_regions = false, .max_findings = 1000});
  if (report.has(Defect::inconsistent_labels)) return false;
  return open_edge_count(mesh) > 0 || contradictions_on_lines(mesh, true, 1).empty();
}

void turn_labels(SurfaceData& data) {
  for (Labels& labels : data.labels) labels = labels.flipped();
}

bool turn_if_inside_out(SurfaceData& data) {
  if (!data.pair_arrays.empty() || is_consistent(data)) return false;
  turn_labels(data);
  if (is_consistent(data)) return true;
  turn_labels(data);
  return false;
}

}  // namespace

std::vector<std::string> tidy_surface(SurfaceData& data) {
  std::vector<std::string> notes;
  if (const std::size_t unused = drop_unused_vertices(data); unused > 0)
    notes.push_back(std::to_string(unused) + " vertices that no triangle uses are dropped; " +
                    std::to_string(data.positions.size()) + " are left");
  if (turn_if_inside_out(data))
    notes.emplace_back(
        "the surface is inside out: its triangles' normals point out of their second region into the first, and their "
        "labels are turned");
  return notes;
}

}  // namespace lostopos
