#include "LosTopos/io/surface_edit.h"

namespace lostopos {
namespace {

// Which elements' values stay, in their order.
template <class T>
void keep_values(const std::vector<std::size_t>& kept, std::vector<T>& values, std::size_t width = 1) {
  std::vector<T> stay;
  stay.reserve(kept.size() * width);
  for (const std::size_t element : kept)
    for (std::size_t i = 0; i < width; ++i) stay.push_back(values[element * width + i]);
  values = std::move(stay);
}

void keep_pairs(const std::vector<std::size_t>& kept, PairArray& array) {
  PairArray stay{array.name, {0}, {}};
  for (const std::size_t v : kept) {
    stay.values.insert(stay.values.end(), array.at(v).begin(), array.at(v).end());
    stay.offsets.push_back(stay.values.size());
  }
  array = std::move(stay);
}

}  // namespace

void renumber_vertices(SurfaceData& data, const std::vector<std::uint32_t>& numbers) {
  std::vector<std::size_t> kept;
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] == kept.size()) kept.push_back(v);  // the first with the next number
  keep_values(kept, data.positions);
  for (PairArray& array : data.pair_arrays) keep_pairs(kept, array);
  for (DataArray& array : data.vertex_arrays)
    keep_values(kept, array.values, static_cast<std::size_t>(array.components));
  for (auto& triangle : data.triangles)
    for (std::uint32_t& corner : triangle) corner = numbers[corner];
  std::erase_if(data.lines, [&](const auto& line) {
    return numbers[line[0]] == dropped_vertex || numbers[line[1]] == dropped_vertex ||
           numbers[line[0]] == numbers[line[1]];
  });
  for (auto& line : data.lines)
    for (std::uint32_t& end : line) end = numbers[end];
  std::erase_if(data.held, [&](const HeldVertex& held) { return numbers[held.vertex] == dropped_vertex; });
  for (HeldVertex& held : data.held) held.vertex = numbers[held.vertex];
}

void replace_triangles(SurfaceData& data, std::vector<std::array<std::uint32_t, 3>> triangles,
                       const std::vector<std::size_t>& parents) {
  data.triangles = std::move(triangles);
  data.lines.clear();  // edges of what was there
  keep_values(parents, data.labels);
  for (DataArray& array : data.triangle_arrays)
    keep_values(parents, array.values, static_cast<std::size_t>(array.components));
}

}  // namespace lostopos
