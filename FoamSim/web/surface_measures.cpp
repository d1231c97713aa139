#include "FoamSim/web/surface_measures.h"

#include <Eigen/Geometry>
#include <limits>
#include <map>

#include "FoamSim/statistics/foam_statistics.h"
#include "FoamSim/web/film_parts.h"
#include "LosTopos/io/film_faces.h"

namespace foamsim::web {

using lostopos::SurfaceData;
using lostopos::Vec3;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Twice the triangle's area times its normal, L².
Vec3 doubled_area_vector(const SurfaceData& surface, std::size_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const Vec3 origin = surface.positions[a];
  return (surface.positions[b] - origin).cross(surface.positions[c] - origin);
}

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
  std::vector<double> pull(parts.films, 0), area(parts.films, 0);
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

// Of every region's films, weighted by area.
std::map<std::uint32_t, Vec3> centres_of(const SurfaceData& surface) {
  struct Sum {
    Vec3 moment = Vec3::Zero();
    double area = 0;
  };
  std::map<std::uint32_t, Sum> sums;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const double area = doubled_area_vector(surface, t).norm() / 2;
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 middle = (surface.positions[a] + surface.positions[b] + surface.positions[c]) / 3;
    for (const lostopos::Region region : {surface.labels[t].p, surface.labels[t].q}) {
      Sum& sum = sums[region.index()];
      sum.moment += area * middle;
      sum.area += area;
    }
  }
  std::map<std::uint32_t, Vec3> centres;
  for (const auto& [region, sum] : sums) centres[region] = sum.area > 0 ? Vec3(sum.moment / sum.area) : sum.moment;
  return centres;
}

void add_bubbles(const SurfaceData& surface, const std::vector<std::uint8_t>& solid, SurfaceMeasures& measures) {
  const std::map<std::uint32_t, Vec3> centres = centres_of(surface);
  for (const BubbleStatistics& bubble : foam_statistics(lostopos::to_mesh(surface), solid).bubbles)
    measures.bubbles.push_back({bubble.region.index(), bubble.volume.value_or(nothing), bubble.area,
                                bubble.pressure.value_or(nothing), static_cast<std::uint32_t>(bubble.faces),
                                centres.at(bubble.region.index())});
}

}  // namespace

SurfaceMeasures measure(const SurfaceData& surface) {
  const std::vector<std::uint8_t> solid = lostopos::solid_triangles(surface);
  const FilmParts parts = find_films(surface, solid);
  const VertexCurvatures curvatures = vertex_curvatures(surface, parts);
  SurfaceMeasures measures;
  measures.borders = parts.borders;
  add_fields(surface, parts, curvatures, film_jumps(parts, curvatures), measures);
  add_bubbles(surface, solid, measures);
  return measures;
}

}  // namespace foamsim::web
