#include "FoamSim/conservative/film_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

Eigen::Matrix3d pseudo_inverse(std::span<const Vec3> rows) {
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
  const double least = least_singular_value * least_singular_value * solver.eigenvalues()[2];
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    const Vec3 direction = solver.eigenvectors().col(i);
    if (value > least) inverse += direction * direction.transpose() / value;
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
    map[v] = films.held[v] != 0 || own.empty() ? Eigen::Matrix3d::Zero() : pseudo_inverse(own);
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
