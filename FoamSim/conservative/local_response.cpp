#include "FoamSim/conservative/local_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

LocalResponse::LocalResponse(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                             double delta, const NearField& near)
    : films_(films), shape_(shape), positions_(positions), near_(near), unit_(std::numbers::inv_pi / (4 * delta)) {
  constexpr double reach = 4;        // in δ
  constexpr std::size_t most = 200;  // triangles within that, on average
  const double farthest = reach * delta;
  std::vector<Vec3> middles(films.corners.size());
  for (std::size_t t = 0; t < middles.size(); ++t) {
    const auto& [a, b, c] = films.corners[t];
    middles[t] = (positions[a] + positions[b] + positions[c]) / 3;
  }
  pairs_ = close_pairs(middles, farthest, most);
  kernel_.resize(pairs_.other.size());
  base::parallel_for_each(middles.size(), film_grain, [&](std::size_t t) {
    for (std::size_t i = pairs_.first[t]; i < pairs_.first[t + 1]; ++i) {
      const double square = (middles[pairs_.other[i]] - middles[t]).squaredNorm();
      const double weight = std::max(0.0, 1 - std::sqrt(square) / farthest);
      kernel_[i] = static_cast<float>(weight * weight / std::sqrt(square / (delta * delta) + 1));
    }
  });
}

void LocalResponse::evaluate(std::span<const Vec3> force, std::vector<Vec3>& velocity) {
  pressure_.resize(films_.entries());
  balance(films_, shape_, force, pressure_);
  strength_.resize(films_.corners.size());
  base::parallel_for_each(strength_.size(), film_grain, [&](std::size_t t) {
    Vec3 gamma = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      gamma +=
          (pressure_[films_.front[t][k]] - pressure_[films_.back[t][k]]) / 2 * opposite_edge(films_, t, k, positions_);
    strength_[t] = gamma;
  });
  potential_.resize(strength_.size());
  base::parallel_for_each(strength_.size(), film_grain, [&](std::size_t t) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = pairs_.first[t]; i < pairs_.first[t + 1]; ++i)
      sum += double{kernel_[i]} * strength_[pairs_.other[i]];
    potential_[t] = unit_ * sum;
  });
  near_.add_potential(films_, shape_, strength_, potential_);
  collect_fluxes(films_, positions_, potential_, flux_);
  still_.assign(force.size(), Vec3::Zero());
  velocity.resize(force.size());
  fit_velocities(films_, shape_, flux_, still_, velocity);
}

}  // namespace foamsim
