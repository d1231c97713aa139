#include "FoamSim/conservative/film_connectivity.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <utility>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

namespace {

std::uint32_t entry_of(const SurfaceGeometry& geometry, Vertex v, Region r) {
  const auto regions = geometry.regions(v);
  const auto at = std::ranges::lower_bound(regions, r);
  return static_cast<std::uint32_t>(geometry.first_entry(v) + static_cast<std::size_t>(at - regions.begin()));
}

// The corners of the triangles around each vertex, by counting.
void list_corners(FilmConnectivity& films) {
  films.first_corner.assign(films.vertex_slots() + 1, 0);
  for (const auto& triangle : films.corners)
    for (std::uint32_t v : triangle) ++films.first_corner[v + 1];
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) films.first_corner[v + 1] += films.first_corner[v];
  films.corner_list.resize(3 * films.corners.size());
  std::vector<std::uint32_t> next(films.first_corner.begin(), films.first_corner.end() - 1);
  for (std::uint32_t t = 0; t < films.corners.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) films.corner_list[next[films.corners[t][k]]++] = 3 * t + k;
}

// The triangles of one film around a vertex are a sheet of it.
void list_sheets(FilmConnectivity& films) {
  using Film = std::pair<std::uint32_t, std::uint32_t>;
  const auto film = [&films](std::uint32_t corner) {
    const std::uint32_t p = films.front[corner / 3][corner % 3], q = films.back[corner / 3][corner % 3];
    return Film(std::min(p, q), std::max(p, q));
  };
  boost::container::small_vector<Film, 8> found;
  films.sheets.resize(films.corners.size());
  films.first_sheet.assign(films.vertex_slots() + 1, 0);
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    found.clear();
    for (std::uint32_t corner : films.around(v)) {
      const Film own = film(corner);
      auto it = std::ranges::find(found, own);
      if (it == found.end()) it = found.insert(it, own);
      films.sheets[corner / 3][corner % 3] = films.first_sheet[v] + static_cast<std::uint32_t>(it - found.begin());
    }
    films.first_sheet[v + 1] = films.first_sheet[v] + static_cast<std::uint32_t>(found.size());
  }
}

void find_inner(FilmConnectivity& films) {
  films.inner.assign(films.vertex_slots(), 1);
  const auto one_film = [&films](std::uint32_t v) { return films.first_sheet[v + 1] - films.first_sheet[v] == 1; };
  for (const auto& triangle : films.corners)
    if (!std::ranges::all_of(triangle, one_film))
      for (std::uint32_t v : triangle) films.inner[v] = 0;
}

}  // namespace

void FilmConnectivity::update(const SurfaceMesh& mesh, const SurfaceGeometry& geometry,
                              std::span<const lostopos::Hold> held_vertices, std::span<const std::uint8_t> solid) {
  const std::size_t slots = mesh.vertex_slots();
  held.assign(slots, 0);
  for (std::size_t v = 0; v < std::min(slots, held_vertices.size()); ++v)
    held[v] = lostopos::is_held(held_vertices[v]) ? 1 : 0;
  triangles.clear();
  for (Triangle t : mesh.triangles())
    if (!is_solid(t, solid)) triangles.push_back(t);
  corners.resize(triangles.size());
  front.resize(triangles.size());
  back.resize(triangles.size());
  base::parallel_for_each(triangles.size(), 512, [&](std::size_t i) {
    const auto vertices = mesh.vertices(triangles[i]);
    const auto labels = mesh.labels(triangles[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      corners[i][k] = vertices[k].index();
      front[i][k] = entry_of(geometry, vertices[k], labels.p);
      back[i][k] = entry_of(geometry, vertices[k], labels.q);
    }
  });
  list_corners(*this);
  list_sheets(*this);
  find_inner(*this);
  first_entry.assign(slots + 1, 0);
  regions.clear();
  for (std::size_t v = 0; v < slots; ++v) {
    if (mesh.alive(Vertex(static_cast<std::uint32_t>(v)))) {
      const auto own = geometry.regions(Vertex(static_cast<std::uint32_t>(v)));
      regions.insert(regions.end(), own.begin(), own.end());
    }
    first_entry[v + 1] = static_cast<std::uint32_t>(regions.size());
  }
}

}  // namespace foamsim
