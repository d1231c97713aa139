#include "FoamSim/sheet/velocity/interaction.h"

#include <Eigen/Core>
#include <algorithm>
#include <numbers>

namespace foamsim {

namespace {

using Values = Eigen::Map<const Eigen::ArrayXd>;

// So many sums over all cost no more than those by clusters over all at once.
constexpr std::size_t most_few = 512;

std::vector<std::size_t> not_zero(const VortexSources& sources) {
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < sources.size(); ++t)
    if (sources.gx[t] != 0 || sources.gy[t] != 0 || sources.gz[t] != 0) found.push_back(t);
  return found;
}

double sum_over_few(const VortexSources& part, std::span<const std::size_t> few, const VortexSources& all,
                    double delta) {
  const auto values = [](const VortexSources::Array& array) {
    return Values(array.data(), static_cast<Eigen::Index>(array.size()));
  };
  const Values x = values(all.x), y = values(all.y), z = values(all.z);
  const Values gx = values(all.gx), gy = values(all.gy), gz = values(all.gz);
  double sum = 0;
  for (std::size_t t : few)
    sum += ((part.gx[t] * gx + part.gy[t] * gy + part.gz[t] * gz) /
            ((x - part.x[t]).square() + (y - part.y[t]).square() + (z - part.z[t]).square() + delta * delta).sqrt())
               .sum();
  return sum * std::numbers::inv_pi / 4;
}

}  // namespace

double interaction(const VortexSources& part, const VortexSources& all, double delta, PairSummation& pairs) {
  const std::vector<std::size_t> few = not_zero(part);
  if (few.size() <= std::min(most_few, all.size() / 4)) return sum_over_few(part, few, all, delta);
  PairSums sums;
  pairs.evaluate(all, delta, PairTerms::potential, sums);
  double sum = 0;
  for (std::size_t t : few) sum += lostopos::Vec3(part.gx[t], part.gy[t], part.gz[t]).dot(sums.potential[t]);
  return sum;
}

}  // namespace foamsim
