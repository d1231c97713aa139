#include "FoamSim/conservative/correction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "Base/parallel/for_each.h"
#include "FoamSim/linear/dense_solve.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

using Row = Eigen::Matrix<double, 7, 1>;  // derivatives with respect to one φ: energy, impulse, angular impulse

// ∂/∂φ of ∫ 2Γ x × n dA for corner k of t, Γ and x linear.
Vec3 angular_part(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> x, const Vec3& about,
                  std::size_t t, std::size_t k) {
  const auto& c = films.corners[t];
  return ((x[c[0]] - about) + (x[c[1]] - about) + (x[c[2]] - about) + (x[c[k]] - about)).cross(shape.area_vector[t]) /
         6;
}

// By entry: the derivatives of the angular impulse.
std::vector<Vec3> angular_gradient(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> x,
                                   const Vec3& about) {
  std::vector<Vec3> gradient(films.entries(), Vec3::Zero());
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      const Vec3 part = angular_part(films, shape, x, about, t, k);
      gradient[films.front[t][k]] += part;
      gradient[films.back[t][k]] -= part;
    }
  });
  return gradient;
}

}  // namespace

Invariants impulses(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                    const Vec3& about, std::span<const double> phi) {
  const std::vector<Vec3> angular = angular_gradient(films, shape, positions, about);
  Invariants sum;
  for (std::size_t e = 0; e < films.entries(); ++e) {
    sum.impulse += 2 * phi[e] * shape.region_gradient[e];
    sum.angular_impulse += phi[e] * angular[e];
  }
  return sum;
}

double correct_invariants(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                          const Vec3& about, std::span<const double> flux, const Invariants& wanted,
                          std::span<double> phi) {
  const std::vector<Vec3> angular = angular_gradient(films, shape, positions, about);
  const bool free = std::ranges::all_of(films.held, [](std::uint8_t held) { return held == 0; });
  const auto row = [&](std::size_t e) {
    Row value = Row::Zero();
    value[0] = -2 * flux[e];
    if (free) value << value[0], 2 * shape.region_gradient[e], angular[e];
    return value;
  };
  // Least squares in the norm Σ A_v φ²: with one multiplier a row.
  Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
  std::vector<double> inverse_area(films.vertex_slots(), 0.0);
  double before = 0;
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    double area = 0;
    for (std::uint32_t corner : films.around(v)) area += shape.area[corner / 3] / 3;
    if (films.held[v] != 0 || !(area > 0)) continue;
    inverse_area[v] = 1 / area;
    double mean = 0;
    const double count = films.first_entry[v + 1] - films.first_entry[v];
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) {
      normal += row(e) * row(e).transpose() / area;
      mean += phi[e] / count;
    }
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      before += area * (phi[e] - mean) * (phi[e] - mean);
  }
  Row right;
  right << wanted.energy, wanted.impulse, wanted.angular_impulse;
  if (!free) right.tail<6>().setZero();
  // Scaled to a unit diagonal; what is then below rounding (air at rest, a symmetric motion) is left alone.
  Row scale;
  for (int i = 0; i < 7; ++i) scale[i] = normal(i, i) > 0 ? 1 / std::sqrt(normal(i, i)) : 0.0;
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Row multipliers = scale.cwiseProduct(least_squares(scaled, scale.cwiseProduct(right)));
  double change = 0;
  for (std::size_t v = 0; v < films.vertex_slots(); ++v)
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) {
      const double step = inverse_area[v] * row(e).dot(multipliers);
      phi[e] += step;
      if (inverse_area[v] > 0) change += step * step / inverse_area[v];
    }
  return before > 0 ? std::sqrt(change / before) : 0.0;
}

}  // namespace foamsim
