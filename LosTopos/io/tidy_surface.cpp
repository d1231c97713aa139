#include "LosTopos/io/tidy_surface.h"

#include <algorithm>

#include "LosTopos/io/surface_edit.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_lines.h"

namespace lostopos {
namespace {

// The new number of each vertex, or `dropped_vertex`.
std::vector<std::uint32_t> numbers_of_used_vertices(const SurfaceData& data) {
  std::vector<std::uint32_t> numbers(data.positions.size(), dropped_vertex);
  for (const auto& triangle : data.triangles)
    for (const std::uint32_t corner : triangle) numbers[corner] = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& number : numbers)
    if (number != dropped_vertex) number = next++;
  return numbers;
}

std::size_t drop_unused_vertices(SurfaceData& data) {
  const std::vector<std::uint32_t> numbers = numbers_of_used_vertices(data);
  const std::size_t before = data.positions.size();
  const auto unused = static_cast<std::size_t>(std::ranges::count(numbers, dropped_vertex));
  if (unused == 0 || unused == before) return 0;
  renumber_vertices(data, numbers);
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
