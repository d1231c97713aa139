#include "FoamSim/conservative/stable_step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "Base/parallel/for_each.h"
#include "FoamSim/conservative/vertex_vectors.h"
#include "FoamSim/linear/dense_solve.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

using Vectors = std::vector<Vec3>;

constexpr double negligible = 1e-12;

// Numbers in [-1, 1) that are the same everywhere and have no pattern.
double scattered(std::size_t i) {
  const auto hashed = static_cast<std::uint32_t>((i + 1) * 2654435761U) ^ static_cast<std::uint32_t>(i >> 5);
  return static_cast<double>(hashed % 65536) / 32768 - 1;
}

// H y, L⁴/T² for y in L; `tilt` is scratch, by triangle.
void restoring_force(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> x, double tension,
                     const Vectors& y, Vectors& tilt, Vectors& force) {
  tilt.resize(films.corners.size());
  base::parallel_for_each(tilt.size(), film_grain, [&](std::size_t t) {
    tilt[t].setZero();
    if (!(shape.area[t] > 0)) return;
    const Vec3 normal = shape.area_vector[t] / shape.area[t];
    for (std::size_t k = 0; k < 3; ++k) tilt[t] += opposite_edge(films, t, k, x) * normal.dot(y[films.corners[t][k]]);
    tilt[t] *= tension / (4 * shape.area[t]);
  });
  force.resize(y.size());
  base::parallel_for_each(y.size(), film_grain, [&](std::size_t v) {
    Vec3 sum = Vec3::Zero();
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3;
      if (!(shape.area[t] > 0)) continue;
      sum += opposite_edge(films, t, corner % 3, x).dot(tilt[t]) / shape.area[t] * shape.area_vector[t];
    }
    force[v] = sum;
  });
}

void scale(Vectors& x, double by) {
  for (Vec3& value : x) value *= by;
}

// The largest eigenvalue of S H from below, by Lanczos' method: in the product y·H z of two vectors S H is symmetric,
// and on what a few rounds have reached it is a tridiagonal matrix.
double fastest_square(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                      double tension, LocalResponse& response) {
  constexpr std::size_t rounds = 6;
  Vectors y(films.vertex_slots()), before(y.size(), Vec3::Zero()), tilt, force, next;
  for (std::size_t v = 0; v < y.size(); ++v) y[v] = Vec3(scattered(3 * v), scattered(3 * v + 1), scattered(3 * v + 2));
  restoring_force(films, shape, positions, tension, y, tilt, force);
  double square = 0, size = std::sqrt(dot(y, force)), beside = 0;
  std::vector<double> diagonals, besides;
  while (size > 0 && std::isfinite(1 / size)) {
    scale(y, 1 / size);
    scale(force, 1 / size);
    response.evaluate(force, next);
    const double diagonal = dot(force, next);
    if (!std::isfinite(diagonal)) break;
    diagonals.push_back(diagonal);
    square = largest_eigenvalue(diagonals, besides);
    if (diagonals.size() == rounds) break;
    for (std::size_t v = 0; v < y.size(); ++v) next[v] -= diagonal * y[v] + beside * before[v];
    before.swap(y);
    y.swap(next);
    restoring_force(films, shape, positions, tension, y, tilt, force);
    size = beside = std::sqrt(std::max(0.0, dot(y, force)));
    if (!(beside > negligible * square)) break;  // nothing else is reached
    besides.push_back(beside);
  }
  return square;
}

}  // namespace

double stable_step(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                   double tension, LocalResponse& response) {
  constexpr double from_below = 1.2;
  if (!(tension > 0) || films.corners.empty()) return std::numeric_limits<double>::infinity();
  const double square = fastest_square(films, shape, positions, tension, response);
  return square > 0 ? 2 / (from_below * std::sqrt(square)) : std::numeric_limits<double>::infinity();
}

double resolved_step(const FilmConnectivity& films, std::span<const Vec3> positions, std::span<const Vec3> velocity) {
  double fastest = 0;
  for (const auto& corners : films.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = corners[k], b = corners[(k + 1) % 3];
      const double length = (positions[b] - positions[a]).squaredNorm();
      if (length > 0) fastest = std::max(fastest, (velocity[b] - velocity[a]).squaredNorm() / length);
    }
  return fastest > 0 ? 1 / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

}  // namespace foamsim
