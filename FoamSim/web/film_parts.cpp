#include "FoamSim/web/film_parts.h"

#include <algorithm>

#include "LosTopos/io/film_faces.h"

namespace foamsim::web {

using lostopos::SurfaceData;

namespace {

void find_inner_vertices(const SurfaceData& surface, FilmParts& parts) {
  std::vector<std::uint8_t> at_the_rim(surface.positions.size(), 0);
  for (const auto& edges : {parts.borders, lostopos::free_edges(surface)})
    for (const auto& [a, b] : edges) at_the_rim[a] = at_the_rim[b] = 1;
  parts.inner_film.assign(surface.positions.size(), FilmParts::none);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::uint32_t v : surface.triangles[t]) {
      std::uint32_t& film = parts.inner_film[v];
      if (parts.film[t] == FilmParts::none || (film != FilmParts::none && film != parts.film[t])) at_the_rim[v] = 1;
      film = parts.film[t];
    }
  for (std::size_t v = 0; v < at_the_rim.size(); ++v)
    if (at_the_rim[v] != 0) parts.inner_film[v] = FilmParts::none;
}

}  // namespace

FilmParts find_films(const SurfaceData& surface, const std::vector<std::uint8_t>& solid) {
  FilmParts parts;
  parts.film = lostopos::film_numbers(surface, solid);
  for (std::uint32_t film : parts.film) parts.films = std::max<std::size_t>(parts.films, film + 1);
  for (std::size_t t = 0; t < solid.size(); ++t)
    if (solid[t] != 0) parts.film[t] = FilmParts::none;
  parts.borders = lostopos::border_edges(surface);
  find_inner_vertices(surface, parts);
  return parts;
}

}  // namespace foamsim::web
