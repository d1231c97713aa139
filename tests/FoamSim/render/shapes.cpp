#include "shapes.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace foamsim::render {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

// A cap over a circle of `n` vertices that start at `rim`: x(t, a) with t = 0 the tip and t = 1 the circle.
void add_cap(Surface& s, int n, int rings, std::uint32_t rim, std::array<std::int32_t, 2> labels, bool flip,
             const std::function<Vector3d(double, double)>& x) {
  const auto tip = static_cast<std::uint32_t>(s.positions.size());
  s.positions.push_back(x(0, 0));
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < n; ++j) s.positions.push_back(x(static_cast<double>(i) / rings, 2 * kPi * j / n));
  const auto at = [&](int i, int j) -> std::uint32_t {
    if (i == 0) return tip;
    return (i == rings ? rim : tip + 1 + (i - 1) * n) + j % n;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (flip) std::swap(b, c);
    s.triangles.push_back({a, b, c});
    s.labels.push_back(labels);
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < n; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      if (i > 0) add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

Vector3d around_x(double x, double r, double a) {
  return {x, r * std::cos(a), r * std::sin(a)};
}

}  // namespace

Surface sphere(int n, double radius, const Vector3d& centre, int inside, int outside) {
  Surface s;
  for (int j = 0; j < n; ++j) s.positions.push_back(centre + around_x(0, radius, 2 * kPi * j / n));
  for (const int side : {1, -1}) {
    add_cap(s, n, n / 4, 0, {inside, outside}, side < 0, [&](double t, double a) -> Vector3d {
      return centre + around_x(side * radius * std::cos(t * kPi / 2), radius * std::sin(t * kPi / 2), a);
    });
  }
  return s;
}

Surface double_bubble(int n) {
  Surface s;
  const double rim = std::sqrt(3.0) / 2;
  for (int j = 0; j < n; ++j) s.positions.push_back(around_x(0, rim, 2 * kPi * j / n));
  for (const int side : {1, -1}) {
    add_cap(s, n, n / 3, 0, {side > 0 ? 2 : 1, 0}, side < 0, [&](double t, double a) {
      const double angle = t * 2 * kPi / 3;
      return around_x(side * (0.5 + std::cos(angle)), std::sin(angle), a);
    });
  }
  add_cap(s, n, n / 6, 0, {1, 2}, false, [&](double t, double a) { return around_x(0, t * rim, a); });
  return s;
}

void append(Surface& surface, const Surface& other) {
  const auto base = static_cast<std::uint32_t>(surface.positions.size());
  surface.positions.insert(surface.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& t : other.triangles) surface.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  surface.labels.insert(surface.labels.end(), other.labels.begin(), other.labels.end());
}

}  // namespace foamsim::render
