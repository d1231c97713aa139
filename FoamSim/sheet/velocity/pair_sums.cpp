#include "FoamSim/sheet/velocity/pair_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Base/error.h"
#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/pair_kernel.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Enough for the threads of a workstation; each costs nine doubles a triangle.
constexpr std::size_t most_groups = 16;

// What lengths and strengths are divided by, so that singles can hold them, and what is taken from places.
struct Units {
  double x = 0, y = 0, z = 0, length = 1, strength = 1;
};

// In multiples of δ about the middle.
Units units_of(const VortexSources& sources, double delta) {
  const auto middle = [](const VortexSources::Array& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return least + (most - least) / 2;
  };
  double strongest = 0;
  for (const auto* values : {&sources.gx, &sources.gy, &sources.gz})
    for (double value : *values) strongest = std::max(strongest, std::abs(value));
  return {middle(sources.x), middle(sources.y), middle(sources.z), delta, strongest > 0 ? strongest : 1};
}

template <class Real>
void put_bodies(const VortexSources& sources, const Units& units, PairBodies<Real>& bodies) {
  const std::size_t padded = (sources.size() + pair_row - 1) / pair_row * pair_row;
  const auto put = [padded](const VortexSources::Array& from, double origin, double unit, auto& to) {
    to.assign(padded, Real{0});
    for (std::size_t t = 0; t < from.size(); ++t) to[t] = static_cast<Real>((from[t] - origin) / unit);
  };
  put(sources.x, units.x, units.length, bodies.x);
  put(sources.y, units.y, units.length, bodies.y);
  put(sources.z, units.z, units.length, bodies.z);
  put(sources.gx, 0, units.strength, bodies.gx);
  put(sources.gy, 0, units.strength, bodies.gy);
  put(sources.gz, 0, units.strength, bodies.gz);
}

}  // namespace

// The first rows have the most pairs: group g takes the rows g, 2G − 1 − g, 2G + g, ..., which gives each about the
// same number.
template <class Real>
void DirectPairSums::add_up(const PairBodies<Real>& bodies, double delta_squared, PairTerms terms) {
  const bool all = terms == PairTerms::all;
  const std::size_t stride = bodies.x.size(), rows = stride / pair_row;
  const std::size_t groups = std::clamp<std::size_t>(rows, 1, most_groups);
  const auto [begin, end] = ranks_->share(groups);
  parts_.resize(end - begin);
  base::parallel_for_each(end - begin, 1, [&, begin = begin](std::size_t i) {
    const std::size_t group = begin + i;
    auto& out = parts_[i];
    out.assign((all ? all_components : potential_components) * stride, 0.0);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t turn = row % (2 * groups);
      if (std::min(turn, 2 * groups - 1 - turn) != group) continue;
      add_pair_row(bodies, row, delta_squared, all, out.data(), stride);
    }
  });
  totals_.assign((all ? all_components : potential_components) * stride, 0.0);
  ranks_->in_turn(totals_, [this] {
    base::parallel_for_each(totals_.size(), 4096, [this](std::size_t i) {
      for (const auto& part : parts_) totals_[i] += part[i];
    });
  });
}

void DirectPairSums::evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) {
  if (!std::isfinite(delta) || !(delta > 0)) throw base::InputError("delta has to be a finite length > 0");
  const std::size_t n = sources.size();
  const bool all = terms == PairTerms::all;
  const bool single = precision_ == Precision::singles || (precision_ == Precision::automatic && n >= many_triangles);
  Units units;
  if (single && n > 0) {
    units = units_of(sources, delta);
    put_bodies(sources, units, singles_);
    add_up(singles_, 1.0, terms);
  } else {
    put_bodies(sources, units, doubles_);
    add_up(doubles_, delta * delta, terms);
  }
  const std::size_t stride = totals_.size() / (all ? all_components : potential_components);
  sums.potential.resize(n);
  sums.force.resize(all ? n : 0);
  sums.velocity.resize(all ? n : 0);
  constexpr double scale = std::numbers::inv_pi / 4;
  const double of_potential = units.strength / units.length, of_velocity = of_potential / units.length;
  const double of_force = of_velocity * units.strength;
  base::parallel_for_each(n, 256, [&](std::size_t t) {
    const auto total = [&](std::size_t c) { return totals_[c * stride + t]; };
    const Vec3 own(sources.gx[t], sources.gy[t], sources.gz[t]);
    sums.potential[t] = scale * (of_potential * Vec3(total(0), total(1), total(2)) + own / delta);
    if (!all) return;
    sums.force[t] = scale * of_force * Vec3(total(3), total(4), total(5));
    sums.velocity[t] = scale * of_velocity * Vec3(total(6), total(7), total(8));
  });
}

}  // namespace foamsim
