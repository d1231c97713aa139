#include "FoamSim/web/surface_measures.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "FoamSim/web/film_parts.h"

namespace foamsim::web {

using lostopos::SurfaceData;
using lostopos::Vec3;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Of vertices inside of films: ∇A·n, with n out of the region with the higher number, and a third of the area around.
struct VertexCurvatures {
  std::vector<double> pull, area;
};

VertexCurvatures vertex_curvatures(const SurfaceData& surface, const FilmParts& parts) {
  const std::size_t count = surface.positions.size();
  std::vector<Vec3> gradient(count, Vec3::Zero()), normal(count, Vec3::Zero());
  VertexCurvatures result{std::vector<double>(count, 0), std::vector<double>(count, 0)};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    const Vec3 doubled = doubled_area_vector(surface, t);
    const double length = doubled.norm();
    if (parts.film[t] == FilmParts::none || !(length > 0)) continue;
    const Vec3 unit = doubled / length;
    const double out_of_high = surface.labels[t].p.index() > surface.labels[t].q.index() ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 opposite = surface.positions[corners[(k + 2) % 3]] - surface.positions[corners[(k + 1) % 3]];
      gradient[corners[k]] += 0.5 * unit.cross(opposite);
      normal[corners[k]] += out_of_high * doubled;
      result.area[corners[k]] += length / 6;
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    const double length = normal[v].norm();
    if (length > 0) result.pull[v] = gradient[v].dot(normal[v]) / length;
  }
  return result;
}

// By film, twice the mean curvature: ΣN ∇A·n / ΣA over the vertices inside of it.
std::vector<double> film_jumps(const FilmParts& parts, const VertexCurvatures& curvatures) {
  std::vector<double> pull(parts.films.size(), 0), area(parts.films.size(), 0);
  for (std::size_t v = 0; v < parts.inner_film.size(); ++v) {
    const std::uint32_t film = parts.inner_film[v];
    if (film == FilmParts::none) continue;
    pull[film] += curvatures.pull[v];
    area[film] += curvatures.area[v];
  }
  for (std::size_t f = 0; f < pull.size(); ++f) pull[f] = area[f] > 0 ? pull[f] / area[f] : nothing;
  return pull;
}

void add_fields(const SurfaceData& surface, const FilmParts& parts, const VertexCurvatures& curvatures,
                const std::vector<double>& jumps, SurfaceMeasures& measures) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    double sum = 0;
    int corners = 0;
    for (std::uint32_t v : surface.triangles[t]) {
      if (parts.inner_film[v] == FilmParts::none || !(curvatures.area[v] > 0)) continue;
      sum += curvatures.pull[v] / (2 * curvatures.area[v]);
      ++corners;
    }
    const bool film = parts.film[t] != FilmParts::none;
    measures.mean_curvature.push_back(film && corners > 0 ? sum / corners : nothing);
    measures.pressure_jump.push_back(film ? jumps[parts.film[t]] : nothing);
  }
}

// The two regions of a triangle, and whether its normal points out of them.
std::array<std::pair<std::uint32_t, int>, 2> sides_of(const SurfaceData& surface, std::size_t t) {
  return {std::pair(static_cast<std::uint32_t>(surface.labels[t].p.index()), 1),
          std::pair(static_cast<std::uint32_t>(surface.labels[t].q.index()), -1)};
}

using Rows = std::map<std::uint32_t, Eigen::Index>;

// Least squares of p_high − p_low = jump with p = 0 in the air.
Eigen::VectorXd pressures(const FilmParts& parts, const std::vector<double>& jumps, const Rows& rows) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count), weight = Eigen::VectorXd::Zero(count);
  double total = 0;
  for (std::size_t f = 0; f < jumps.size(); ++f) {
    const auto& [low, high, area] = parts.films[f];
    if (std::isnan(jumps[f]) || low == high) continue;
    total += area;
    const Eigen::Index h = rows.at(high);
    entries.emplace_back(h, h, area);
    right[h] += area * jumps[f];
    weight[h] += area;
    if (low == 0) continue;
    const Eigen::Index l = rows.at(low);
    entries.emplace_back(l, l, area);
    entries.emplace_back(h, l, -area);
    entries.emplace_back(l, h, -area);
    right[l] -= area * jumps[f];
    weight[l] += area;
  }
  // A little of the whole keeps bubbles that no film ties to the air from making the system singular.
  for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, 1e-12 * total);
  Eigen::SparseMatrix<double> system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd result = Eigen::VectorXd::Constant(count, nothing);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  if (count > 0 && total > 0 && solver.info() == Eigen::Success) result = solver.solve(right);
  for (Eigen::Index i = 0; i < count; ++i)
    if (!(weight[i] > 0) || !std::isfinite(result[i])) result[i] = nothing;
  return result;
}

// Regions whose films, with solids, leave an edge open: every edge of a closed boundary has its sides in pairs.
std::map<std::uint32_t, bool> closed_regions(const SurfaceData& surface) {
  struct Side {
    std::array<std::uint32_t, 3> region_and_edge;
    int sign;
  };
  std::vector<Side> sides;
  sides.reserve(6 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const auto& [region, sign] : sides_of(surface, t))
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
        sides.push_back({{region, std::min(a, b), std::max(a, b)}, a < b ? sign : -sign});
      }
  std::ranges::sort(sides, {}, &Side::region_and_edge);
  std::map<std::uint32_t, bool> closed;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    int sum = 0;
    for (end = begin; end < sides.size() && sides[end].region_and_edge == sides[begin].region_and_edge; ++end)
      sum += sides[end].sign;
    bool& whole = closed.try_emplace(sides[begin].region_and_edge[0], true).first->second;
    whole = whole && sum == 0;
  }
  return closed;
}

void add_bubbles(const SurfaceData& surface, const FilmParts& parts, const std::vector<double>& jumps,
                 SurfaceMeasures& measures) {
  const std::map<std::uint32_t, bool> closed = closed_regions(surface);
  Rows rows;
  for (const auto& [region, whole] : closed)
    if (region != 0) rows.emplace(region, static_cast<Eigen::Index>(rows.size()));
  for (const auto& [region, row] : rows) measures.bubbles.push_back({region, 0, 0, 0, 0, Vec3::Zero()});
  const Eigen::VectorXd pressure = pressures(parts, jumps, rows);
  const Vec3 origin = surface.positions.empty() ? Vec3::Zero().eval() : surface.positions.front();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3 doubled = doubled_area_vector(surface, t);
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 middle = (surface.positions[a] + surface.positions[b] + surface.positions[c]) / 3;
    for (const auto& [region, sign] : sides_of(surface, t)) {
      if (region == 0) continue;
      BubbleMeasures& bubble = measures.bubbles[static_cast<std::size_t>(rows.at(region))];
      bubble.volume += sign * doubled.dot(surface.positions[a] - origin) / 6;
      bubble.area += doubled.norm() / 2;
      bubble.centre += doubled.norm() / 2 * middle;
    }
  }
  for (const FilmParts::Film& film : parts.films)
    for (std::uint32_t region : {film.low, film.high})
      if (region != 0) ++measures.bubbles[static_cast<std::size_t>(rows.at(region))].faces;
  for (BubbleMeasures& bubble : measures.bubbles) {
    bubble.pressure = pressure[rows.at(bubble.region)];
    if (bubble.area > 0) bubble.centre /= bubble.area;
    if (!closed.at(bubble.region)) bubble.volume = nothing;
  }
}

}  // namespace

SurfaceMeasures measure(const SurfaceData& surface) {
  const FilmParts parts = find_films(surface);
  const VertexCurvatures curvatures = vertex_curvatures(surface, parts);
  const std::vector<double> jumps = film_jumps(parts, curvatures);
  SurfaceMeasures measures;
  measures.borders = parts.borders;
  add_fields(surface, parts, curvatures, jumps, measures);
  add_bubbles(surface, parts, jumps, measures);
  return measures;
}

}  // namespace foamsim::web
