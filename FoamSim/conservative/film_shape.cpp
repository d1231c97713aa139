#include "FoamSim/conservative/film_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// 1/value, but for a direction that is barely seen: there it falls to zero with the value.
double damped_inverse(double value, double largest) {
  const double weak = weak_singular_value * weak_singular_value * largest;
  if (!(value > 0)) return 0;
  return value > weak ? 1 / value : value / (weak * weak);
}

Eigen::Matrix3d damped_pseudo_inverse(std::span<const Vec3> rows) {
  // Two regions have opposite gradients: one direction.
  if (rows.size() == 2) {
    const double square = rows[0].squaredNorm();
    return square > 0 ? Eigen::Matrix3d(rows[0] * rows[0].transpose() / (2 * square * square))
                      : Eigen::Matrix3d::Zero();
  }
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const Vec3& a : rows) gram += a * a.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gram);
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 direction = solver.eigenvectors().col(i);
    inverse += damped_inverse(solver.eigenvalues()[i], solver.eigenvalues()[2]) * direction * direction.transpose();
  }
  return inverse;
}

}  // namespace

void FilmShape::update(const FilmConnectivity& films, std::span<const Vec3> positions) {
  area_vector.resize(films.corners.size());
  area.resize(films.corners.size());
  base::parallel_for_each(films.corners.size(), film_grain, [&](std::size_t t) {
    const auto& [a, b, c] = films.corners[t];
    area_vector[t] = 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    area[t] = area_vector[t].norm();
  });
  region_gradient.assign(films.entries(), Vec3::Zero());
  map.resize(films.vertex_slots());
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      region_gradient[films.front[t][k]] += area_vector[t] / 3;
      region_gradient[films.back[t][k]] -= area_vector[t] / 3;
    }
    const std::span<const Vec3> own{region_gradient.data() + films.first_entry[v],
                                    region_gradient.data() + films.first_entry[v + 1]};
    map[v] = films.held[v] != 0 || own.empty() ? Eigen::Matrix3d::Zero() : damped_pseudo_inverse(own);
  });
}

void collect_fluxes(const FilmConnectivity& films, std::span<const Vec3> positions, std::span<const Vec3> potential,
                    std::vector<double>& flux) {
  flux.assign(films.entries(), 0.0);
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      const double part = 0.5 * opposite_edge(films, t, k, positions).dot(potential[t]);
      flux[films.front[t][k]] += part;
      flux[films.back[t][k]] -= part;
    }
  });
}

void balance(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> force,
             std::span<double> pressure) {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    const Vec3 mapped = shape.map[v] * force[v];
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      pressure[e] = shape.region_gradient[e].dot(mapped);
  });
}

double unbalanced_power(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> force,
                        std::span<const double> pressure, std::span<const Vec3> velocity) {
  double power = 0;
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    Vec3 rest = force[v];
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      rest -= pressure[e] * shape.region_gradient[e];
    power += rest.dot(velocity[v]);
  }
  return power;
}

void fit_velocities(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> flux,
                    std::span<const Vec3> tangential, std::span<Vec3> velocity) {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    Vec3 missing = Vec3::Zero();
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      missing += shape.region_gradient[e] * (flux[e] - shape.region_gradient[e].dot(tangential[v]));
    velocity[v] = films.held[v] != 0 ? Vec3(Vec3::Zero()) : Vec3(tangential[v] + shape.map[v] * missing);
  });
}

}  // namespace foamsim
