#include "FoamSim/conservative/pair_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Base/error.h"
#include "Base/parallel/for_each.h"
#include "FoamSim/conservative/pair_kernel.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Enough for the threads of a workstation; each costs nine doubles a triangle.
constexpr std::size_t most_groups = 16;

}  // namespace

// The first rows have the most pairs: group g takes the rows g, 2G − 1 − g, 2G + g, ..., which gives each about the
// same number.
void DirectPairSums::evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) {
  if (!std::isfinite(delta) || !(delta > 0)) throw base::InputError("delta has to be a finite length > 0");
  const std::size_t n = sources.size();
  const bool all = terms == PairTerms::all;
  const std::size_t components = all ? all_components : potential_components;
  const std::size_t rows = (n + pair_row - 1) / pair_row;
  const std::size_t stride = rows * pair_row;
  VortexSources padded = sources;  // those added have no strength
  padded.resize(stride);
  const std::size_t groups = std::clamp<std::size_t>(rows, 1, most_groups);
  parts_.resize(groups);
  base::parallel_for_each(groups, 1, [&](std::size_t group) {
    VortexSources::Array& out = parts_[group];
    out.assign(components * stride, 0.0);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t turn = row % (2 * groups);
      if (std::min(turn, 2 * groups - 1 - turn) != group) continue;
      add_pair_row(padded, row, delta * delta, all, out.data(), stride);
    }
  });
  sums.potential.resize(n);
  sums.force.resize(all ? n : 0);
  sums.velocity.resize(all ? n : 0);
  constexpr double scale = std::numbers::inv_pi / 4;
  base::parallel_for_each(n, 256, [&](std::size_t t) {
    const auto total = [&](std::size_t c) {
      double sum = 0;
      for (const auto& part : parts_) sum += part[c * stride + t];
      return sum;
    };
    const Vec3 own(sources.gx[t], sources.gy[t], sources.gz[t]);
    sums.potential[t] = scale * (Vec3(total(0), total(1), total(2)) + own / delta);
    if (!all) return;
    sums.force[t] = scale * Vec3(total(3), total(4), total(5));
    sums.velocity[t] = scale * Vec3(total(6), total(7), total(8));
  });
}

}  // namespace foamsim
