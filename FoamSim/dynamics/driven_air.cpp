#include "FoamSim/dynamics/driven_air.h"

#include <algorithm>

namespace foamsim {

using lostopos::Vec3;

void DrivenAir::begin(HeldMotion motion) {
  motion_ = std::move(motion);
  takes_air_ = std::ranges::any_of(motion_.takes_air, [](std::uint8_t takes) { return takes != 0; });
}

bool DrivenAir::jumps() const {
  return motion_.before != motion_.now;
}

void DrivenAir::prescribe(std::span<Vec3> velocity) const {
  for (std::size_t v = 0; v < motion_.driven.size(); ++v)
    if (motion_.driven[v] != 0) velocity[v] = motion_.now[v];
}

double DrivenAir::power(std::span<const Vec3> force) const {
  double sum = 0;
  for (std::size_t v = 0; v < motion_.driven.size(); ++v)
    if (motion_.driven[v] != 0) sum += force[v].dot(motion_.now[v]);
  return sum;
}

double DrivenAir::work(std::span<const Vec3> force_sum, std::span<const Vec3> from, std::span<const Vec3> to) const {
  double sum = 0;
  for (std::size_t v = 0; v < motion_.driven.size(); ++v)
    if (motion_.driven[v] != 0) sum += force_sum[v].dot(to[v] - from[v]) / 2;
  return sum;
}

double DrivenAir::hold(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                       std::span<const double> flux, bool jump, std::span<double> phi, long& iterations) {
  flux_.update(films, shape, positions, motion_.takes_air);
  const std::vector<double> had(phi.begin(), phi.end());
  iterations = std::max(iterations, flux_.solve(flux, motion_.now, phi));
  double work = 0;
  for (std::size_t v = 0; v < motion_.takes_air.size(); ++v) {
    if (motion_.takes_air[v] == 0) continue;
    const Vec3 both = motion_.now[v] + (jump ? motion_.before[v] : motion_.now[v]);
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      work -= (phi[e] - had[e]) * shape.region_gradient[e].dot(both);
  }
  return work;
}

}  // namespace foamsim
