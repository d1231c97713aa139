#include "FoamSim/conservative/mesh_motion.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <optional>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// The middle of the two neighbours along a Plateau border; nothing where borders meet or end.
std::optional<Vec3> middle_of_border(const FilmConnectivity& films, std::size_t v, std::span<const Vec3> x) {
  boost::container::small_vector<std::uint32_t, 24> neighbours;
  for (std::uint32_t corner : films.around(v))
    for (std::uint32_t w : films.corners[corner / 3])
      if (w != v) neighbours.push_back(w);
  std::ranges::sort(neighbours);
  Vec3 sum = Vec3::Zero();
  int along = 0;
  for (auto first = neighbours.begin(); first != neighbours.end();) {
    const auto last = std::upper_bound(first, neighbours.end(), *first);
    if (last - first != 2) {
      sum += x[*first];
      ++along;
    }
    first = last;
  }
  if (along != 2) return {};
  return sum / 2;
}

Vec3 middle_of_films(const FilmConnectivity& films, const FilmShape& shape, std::size_t v, std::span<const Vec3> x) {
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (std::uint32_t corner : films.around(v)) {
    const auto& [a, b, c] = films.corners[corner / 3];
    sum += shape.area[corner / 3] * ((x[a] - x[v]) + (x[b] - x[v]) + (x[c] - x[v])) / 3;
    area += shape.area[corner / 3];
  }
  return area > 0 ? Vec3(x[v] + sum / area) : x[v];
}

// |du/dt| / |edge|, the largest of the edges from v.
double strain_rate(const FilmConnectivity& films, std::size_t v, std::span<const Vec3> x, std::span<const Vec3> u) {
  double fastest = 0;
  for (std::uint32_t corner : films.around(v))
    for (std::uint32_t w : films.corners[corner / 3])
      if (const double square = (x[w] - x[v]).squaredNorm(); square > 0)
        fastest = std::max(fastest, (u[w] - u[v]).squaredNorm() / square);
  return std::sqrt(fastest);
}

}  // namespace

void mean_at_vertices(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> of_triangles,
                      std::vector<Vec3>& of_vertices) {
  of_vertices.assign(films.vertex_slots(), Vec3::Zero());
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    double weight = 0;
    for (std::uint32_t corner : films.around(v)) {
      of_vertices[v] += shape.area[corner / 3] * of_triangles[corner / 3];
      weight += shape.area[corner / 3];
    }
    if (weight > 0) of_vertices[v] /= weight;
  });
}

void add_smoothing(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                   std::span<const Vec3> velocity, std::span<Vec3> tangential) {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    if (films.held[v] != 0 || films.around(v).empty()) return;
    const bool in_film = films.first_sheet[v + 1] - films.first_sheet[v] == 1;
    const std::optional<Vec3> middle =
        in_film ? middle_of_films(films, shape, v, positions) : middle_of_border(films, v, positions);
    if (middle) tangential[v] += strain_rate(films, v, positions, velocity) * (*middle - positions[v]);
  });
}

}  // namespace foamsim
