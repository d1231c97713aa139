#include "FoamSim/conservative/film_motion.h"

#include <Eigen/Geometry>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

void FilmMotion::evaluate(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                          std::span<const double> phi, PairTerms terms) {
  const std::size_t n = films.corners.size();
  corner_circulation_.resize(n);
  strength_.resize(n);
  sources_.resize(n);
  base::parallel_for_each(n, film_grain, [&](std::size_t t) {
    Vec3 gamma = Vec3::Zero(), middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const double circulation = phi[films.front[t][k]] - phi[films.back[t][k]];
      corner_circulation_[t][k] = circulation;
      gamma -= circulation * opposite_edge(films, t, k, positions);
      middle += positions[films.corners[t][k]];
    }
    strength_[t] = gamma;
    sources_.set(t, middle / 3, gamma);
  });
  pairs_->evaluate(sources_, delta_, terms, sums_);
  ++evaluations_;
  near_.add_potential(films, shape, strength_, sums_.potential);
  kinetic_energy_ = 0;
  for (std::size_t t = 0; t < n; ++t) kinetic_energy_ += 0.5 * strength_[t].dot(sums_.potential[t]);
  collect_fluxes(films, positions, sums_.potential, flux_);
}

void FilmMotion::add_inertia(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                             std::span<const Vec3> velocity, std::span<Vec3> force) const {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    Vec3 sum = Vec3::Zero();
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      const auto& corners = films.corners[t];
      const auto& circulation = corner_circulation_[t];
      Vec3 carried = Vec3::Zero(), turning = Vec3::Zero();  // W and Ṅ of docs/method.md's item 5
      for (std::size_t i = 0; i < 3; ++i) {
        carried += circulation[i] * velocity[corners[i]];
        turning -= velocity[corners[i]].cross(opposite_edge(films, t, i, positions));
      }
      const Vec3 opposite = opposite_edge(films, t, k, positions);
      sum += sums_.force[t] / 3 + (circulation[(k + 2) % 3] - circulation[(k + 1) % 3]) * sums_.potential[t];
      sum -= (opposite.cross(carried) + circulation[k] * turning) / 3;
      const double slope = near_.area_slope(films, t);
      if (slope != 0) sum += 0.5 * slope * (shape.area_vector[t] / shape.area[t]).cross(opposite);
    }
    force[v] += sum;
  });
}

FilmImpulse impulse(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi) {
  FilmImpulse impulse;
  for (std::size_t t = 0; t < films.corners.size(); ++t) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += phi[films.front[t][k]] - phi[films.back[t][k]];
    const Vec3 part = 2.0 / 3.0 * sum * shape.area_vector[t];
    impulse.total += part;
    impulse.scale += part.norm();
  }
  return impulse;
}

}  // namespace foamsim
