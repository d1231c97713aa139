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

struct Place {
  Cube cube;
  std::uint32_t point;
  auto operator<=>(const Place&) const = default;
};

constexpr std::size_t grain = 256;

Cube cube_of(const Vec3& x, const Vec3& origin, double size) {
  Cube cube;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    cube[i] = static_cast<std::int64_t>(std::floor((x[axis] - origin[axis]) / size));
  }
  return cube;
}

class Cubes {
 public:
  Cubes(std::span<const Vec3> points, double size) : points_(points), size_(size), places_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      places_[i] = {cube_of(points[i], points[0], size), static_cast<std::uint32_t>(i)};
    std::ranges::sort(places_);
  }

  // Calls what(j) for every point j close to point i.
  template <class What>
  void for_each_close(std::size_t i, What what) const {
    const Cube cube = cube_of(points_[i], points_[0], size_);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        // The three cubes along z follow each other.
        const Cube first{cube[0] + dx, cube[1] + dy, cube[2] - 1}, last{cube[0] + dx, cube[1] + dy, cube[2] + 1};
        for (auto p = std::ranges::lower_bound(places_, Place{first, 0}); p != places_.end() && p->cube <= last; ++p)
          if ((points_[p->point] - points_[i]).squaredNorm() <= size_ * size_) what(p->point);
      }
  }

 private:
  std::span<const Vec3> points_;
  double size_;
  std::vector<Place> places_;
};

}  // namespace

ClosePairs close_pairs(std::span<const Vec3> points, double distance, std::size_t most) {
  constexpr int most_halvings = 8;
  ClosePairs pairs;
  pairs.first.assign(points.size() + 1, 0);
  if (points.empty()) return pairs;
  for (int halvings = 0; halvings <= most_halvings; ++halvings, distance /= 2) {
    const Cubes cubes(points, distance);
    std::vector<std::uint32_t> counts(points.size(), 0);
    base::parallel_for_each(points.size(), grain,
                            [&](std::size_t i) { cubes.for_each_close(i, [&](std::uint32_t) { ++counts[i]; }); });
    const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    if (total > most * points.size() && halvings < most_halvings) continue;
    for (std::size_t i = 0; i < points.size(); ++i) pairs.first[i + 1] = pairs.first[i] + counts[i];
    pairs.other.resize(total);
    base::parallel_for_each(points.size(), grain, [&](std::size_t i) {
      auto to = pairs.other.begin() + pairs.first[i];
      cubes.for_each_close(i, [&](std::uint32_t j) { *to++ = j; });
      std::sort(pairs.other.begin() + pairs.first[i], to);
    });
    break;
  }
  return pairs;
}

}  // namespace foamsim
