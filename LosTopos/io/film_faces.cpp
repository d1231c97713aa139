#include "LosTopos/io/film_faces.h"

#include <algorithm>
#include <utility>

#include "Base/lists/disjoint_sets.h"

namespace lostopos {
namespace {

struct FilmSide {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t triangle;
  auto operator<=>(const FilmSide&) const = default;
};

std::vector<FilmSide> sorted_film_sides(const SurfaceData& data) {
  std::vector<FilmSide> sides;
  sides.reserve(3 * data.triangles.size());
  for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
    const auto& corners = data.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      sides.push_back({{low, high}, t});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

// Calls visit(triangles' sides) for every edge.
template <class Visit>
void for_each_shared_edge(const std::vector<FilmSide>& sides, Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].ends == sides[begin].ends) ++end;
    visit(std::span(sides).subspan(begin, end - begin));
  }
}

std::pair<Region, Region> pair_of(const Labels& labels) {
  return std::minmax(labels.p, labels.q);
}

template <class Wanted>
std::vector<std::array<std::uint32_t, 2>> edges_with(const SurfaceData& data, Wanted wanted) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for_each_shared_edge(sorted_film_sides(data), [&](std::span<const FilmSide> edge) {
    if (wanted(edge.size())) edges.push_back(edge[0].ends);
  });
  return edges;
}

}  // namespace

void put_lower_regions_behind(SurfaceData& data) {
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    if (data.labels[t].p < data.labels[t].q) continue;
    std::swap(data.labels[t].p, data.labels[t].q);
    std::swap(data.triangles[t][1], data.triangles[t][2]);
  }
}

std::vector<std::uint32_t> film_numbers(const SurfaceData& data, std::span<const std::uint8_t> solid) {
  const std::size_t count = data.triangles.size();
  const auto is_solid = [&](std::size_t t) { return t < solid.size() && solid[t] != 0; };
  base::DisjointSets pieces(count);
  for_each_shared_edge(sorted_film_sides(data), [&](std::span<const FilmSide> edge) {
    if (edge.size() != 2) return;
    const std::uint32_t a = edge[0].triangle, b = edge[1].triangle;
    if (pair_of(data.labels[a]) == pair_of(data.labels[b]) && is_solid(a) == is_solid(b)) pieces.unite(a, b);
  });
  std::vector<std::size_t> films;
  for (std::size_t t = 0; t < count; ++t)
    if (pieces.find(t) == t) films.push_back(t);
  std::ranges::stable_sort(films, {}, [&](std::size_t t) { return pair_of(data.labels[t]); });
  std::vector<std::uint32_t> number_of_first(count), numbers(count);
  for (std::uint32_t film = 0; film < films.size(); ++film) number_of_first[films[film]] = film;
  for (std::size_t t = 0; t < count; ++t) numbers[t] = number_of_first[pieces.find(t)];
  return numbers;
}

std::vector<std::array<std::uint32_t, 2>> border_edges(const SurfaceData& data) {
  return edges_with(data, [](std::size_t triangles) { return triangles > 2; });
}

std::vector<std::array<std::uint32_t, 2>> free_edges(const SurfaceData& data) {
  return edges_with(data, [](std::size_t triangles) { return triangles == 1; });
}

std::vector<std::uint8_t> solid_triangles(const SurfaceData& data) {
  std::vector<std::uint8_t> solid(data.triangles.size(), 0);
  for (const DataArray& array : data.triangle_arrays)
    if (array.name == "solid" && array.components == 1)
      for (std::size_t t = 0; t < solid.size(); ++t) solid[t] = array.values[t] != 0 ? 1 : 0;
  return solid;
}

SurfaceData film_picture(SurfaceData data) {
  put_lower_regions_behind(data);
  data.lines = border_edges(data);
  return data;
}

}  // namespace lostopos
