#include "FoamSim/conservative/close_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numeric>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

using Cube = std::array<std::int64_t, 3>;

struct PointInCube {
  Cube cube;
  std::uint32_t point;
  auto operator<=>(const PointInCube&) const = default;
};

constexpr std::size_t grain = 32;

Cube cube_of(const Vec3& x, const Vec3& origin, double size) {
  Cube cube;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    cube[i] = static_cast<std::int64_t>(std::floor((x[axis] - origin[axis]) / size));
  }
  return cube;
}

// Points sorted by cubes as wide as the distance: those close to one lie in its own and the 26 around it.
class Cubes {
 public:
  Cubes(std::span<const Vec3> points, double size) : square_(size * size), places_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      places_[i] = {cube_of(points[i], points[0], size), static_cast<std::uint32_t>(i)};
    std::ranges::sort(places_);
    points_.reserve(places_.size());
    x_.reserve(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      points_.push_back(places_[i].point);
      x_.push_back(points[places_[i].point]);
      if (i == 0 || places_[i].cube != places_[i - 1].cube) first_.push_back(i);
    }
    first_.push_back(places_.size());
  }

  std::size_t count() const { return first_.size() - 1; }

  // How many are close to each of the points in cube c; `count` is by point.
  void count_close(std::size_t c, std::span<std::uint32_t> count) const {
    const auto around = ranges_around(places_[first_[c]].cube);
    for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) {
      std::uint32_t found = 0;
      for (const auto& [begin, end] : around)
        for (std::size_t j = begin; j < end; ++j) found += is_close(i, j) ? 1 : 0;
      count[points_[i]] = found;
    }
  }

  // Lists them, each point's from its first place on.
  void list_close(std::size_t c, std::span<const std::uint32_t> first, std::span<std::uint32_t> list) const {
    const auto around = ranges_around(places_[first_[c]].cube);
    std::vector<std::uint32_t> close;
    for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) {
      std::size_t found = 0;
      for (const auto& [begin, end] : around) {
        close.resize(std::max(close.size(), found + end - begin));
        for (std::size_t j = begin; j < end; ++j) {  // no branch: one in three is close, in no order
          close[found] = points_[j];
          found += is_close(i, j) ? 1 : 0;
        }
      }
      std::copy_n(close.begin(), found, list.begin() + first[points_[i]]);
    }
  }

 private:
  bool is_close(std::size_t i, std::size_t j) const { return (x_[j] - x_[i]).squaredNorm() <= square_; }

  // The three cubes along z follow each other.
  std::array<std::pair<std::size_t, std::size_t>, 9> ranges_around(const Cube& cube) const {
    std::array<std::pair<std::size_t, std::size_t>, 9> ranges;
    std::size_t n = 0;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const Cube first{cube[0] + dx, cube[1] + dy, cube[2] - 1}, behind{cube[0] + dx, cube[1] + dy, cube[2] + 2};
        const auto begin = std::ranges::lower_bound(places_, PointInCube{first, 0});
        auto end = begin;
        while (end != places_.end() && end->cube < behind) ++end;
        ranges[n++] = {begin - places_.begin(), end - places_.begin()};
      }
    return ranges;
  }

  double square_;
  std::vector<PointInCube> places_;
  std::vector<std::uint32_t> points_;  // of the places
  std::vector<Vec3> x_;
  std::vector<std::size_t> first_;  // places of each cube that has any, and their end
};

}  // namespace

ClosePairs close_pairs(std::span<const Vec3> points, double distance, std::size_t most) {
  constexpr int most_halvings = 8;
  ClosePairs pairs;
  pairs.first.assign(points.size() + 1, 0);
  if (points.empty()) return pairs;
  for (int halvings = 0; halvings <= most_halvings; ++halvings, distance /= 2) {
    const Cubes cubes(points, distance);
    // Counted first, so that nothing is kept twice.
    const std::span<std::uint32_t> count = std::span(pairs.first).subspan(1);
    base::parallel_for_each(cubes.count(), grain, [&](std::size_t c) { cubes.count_close(c, count); });
    const std::size_t total = std::accumulate(count.begin(), count.end(), std::size_t{0});
    if (total > most * points.size() && halvings < most_halvings) continue;
    std::partial_sum(pairs.first.begin(), pairs.first.end(), pairs.first.begin());
    pairs.other.resize(total);
    base::parallel_for_each(cubes.count(), grain,
                            [&](std::size_t c) { cubes.list_close(c, pairs.first, pairs.other); });
    break;
  }
  return pairs;
}

}  // namespace foamsim
