#include "FoamSim/web/film_parts.h"

#include <algorithm>
#include <numeric>

namespace foamsim::web {

using lostopos::SurfaceData;

namespace {

struct EdgeSide {
  std::array<std::uint32_t, 2> edge;
  std::uint32_t triangle;
  auto operator<=>(const EdgeSide&) const = default;
};

std::vector<std::uint8_t> solid_triangles(const SurfaceData& surface) {
  std::vector<std::uint8_t> solid(surface.triangles.size(), 0);
  for (const lostopos::DataArray& array : surface.triangle_arrays)
    if (array.name == "solid" && array.components == 1)
      for (std::size_t t = 0; t < solid.size(); ++t) solid[t] = array.values[t] != 0 ? 1 : 0;
  return solid;
}

std::vector<EdgeSide> sides_of_films(const SurfaceData& surface, const std::vector<std::uint8_t>& solid) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; solid[t] == 0 && k < 3; ++k) {
      const std::uint32_t a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, t});
    }
  std::ranges::sort(sides);
  return sides;
}

std::array<std::uint32_t, 2> regions_of(const SurfaceData& surface, std::size_t t) {
  const std::uint32_t p = surface.labels[t].p.index(), q = surface.labels[t].q.index();
  return {std::min(p, q), std::max(p, q)};
}

// Triangles joined to sets, each known by its first.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t first(std::uint32_t i) {
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = first(a);
    b = first(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

void number_films(const SurfaceData& surface, const std::vector<std::uint8_t>& solid, Sets& sets, FilmParts& parts) {
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (solid[t] != 0) continue;
    const std::uint32_t first = sets.first(t);
    if (first == t) {
      parts.film[t] = static_cast<std::uint32_t>(parts.films.size());
      const auto [low, high] = regions_of(surface, t);
      parts.films.push_back({low, high, 0});
    }
    parts.film[t] = parts.film[first];
    parts.films[parts.film[t]].area += doubled_area_vector(surface, t).norm() / 2;
  }
}

void find_inner_vertices(const SurfaceData& surface, const std::vector<std::uint8_t>& at_the_rim, FilmParts& parts) {
  parts.inner_film.assign(surface.positions.size(), FilmParts::none);
  std::vector<std::uint8_t> several = at_the_rim;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::uint32_t v : surface.triangles[t]) {
      std::uint32_t& film = parts.inner_film[v];
      if (parts.film[t] == FilmParts::none || (film != FilmParts::none && film != parts.film[t])) several[v] = 1;
      film = parts.film[t];
    }
  for (std::size_t v = 0; v < several.size(); ++v)
    if (several[v] != 0) parts.inner_film[v] = FilmParts::none;
}

}  // namespace

lostopos::Vec3 doubled_area_vector(const SurfaceData& surface, std::size_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const lostopos::Vec3 origin = surface.positions[a];
  return (surface.positions[b] - origin).cross(surface.positions[c] - origin);
}

FilmParts find_films(const SurfaceData& surface) {
  FilmParts parts;
  const std::vector<std::uint8_t> solid = solid_triangles(surface);
  const std::vector<EdgeSide> sides = sides_of_films(surface, solid);
  std::vector<std::uint8_t> at_the_rim(surface.positions.size(), 0);
  Sets sets(surface.triangles.size());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    for (end = begin; end < sides.size() && sides[end].edge == sides[begin].edge; ++end) {
    }
    const auto& edge = sides[begin].edge;
    const std::uint32_t first = sides[begin].triangle, second = sides[end - 1].triangle;
    if (end - begin == 2 && regions_of(surface, first) == regions_of(surface, second)) {
      sets.join(first, second);
      continue;
    }
    at_the_rim[edge[0]] = at_the_rim[edge[1]] = 1;
    if (end - begin > 2) parts.borders.push_back(edge);
  }
  parts.film.assign(surface.triangles.size(), FilmParts::none);
  number_films(surface, solid, sets, parts);
  find_inner_vertices(surface, at_the_rim, parts);
  return parts;
}

}  // namespace foamsim::web
