#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "Base/error.h"

namespace foamsim {
namespace {

using std::numbers::pi;

constexpr double third_of_a_turn = 2 * pi / 3;
constexpr double largest_ratio = 1e9;

// Volume between a film and the plane of its rim, over the rim's radius cubed; t = tan(polar angle / 2), which is the
// height over the radius of the rim.
double cap_volume(double t) {
  return pi / 6 * t * (3 + t * t);
}

// The half angles' tangents as functions of α = (60° − θ)/2, so that none loses digits where θ nears 60°, the limit of
// a vanishing small bubble: (120° − θ)/2 = 30° + α, (120° + θ)/2 = 90° − α, θ/2 = 30° − α.
struct HalfAngleTangents {
  double smaller, larger, wall;
  explicit HalfAngleTangents(double alpha)
      : smaller(std::tan(pi / 6 + alpha)), larger(1 / std::tan(alpha)), wall(std::tan(pi / 6 - alpha)) {}
  // Of the bubbles, over the rim's radius cubed.
  double smaller_volume() const { return cap_volume(smaller) + cap_volume(wall); }
  double larger_volume() const { return cap_volume(larger) - cap_volume(wall); }
};

double solve_alpha(double volume_ratio) {
  // In logarithms, because the ratio spans decades.
  const auto excess = [volume_ratio](double alpha) {
    const HalfAngleTangents t(alpha);
    return std::log(t.smaller_volume() / t.larger_volume()) - std::log(volume_ratio);
  };
  // Near α = 0 the ratio is 3.85 α³.
  const double low = 0.1 * std::cbrt(volume_ratio), high = pi / 6;
  // Volumes that are equal, or as good as equal.
  if (excess(high) <= 0) return high;
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 1),
      iterations);
  return a + (b - a) / 2;
}

SphericalFilm film(double half_angle_tangent, double polar_angle, double rim) {
  const double sine = 2 * half_angle_tangent / (1 + half_angle_tangent * half_angle_tangent);
  return {sine > 0 ? rim / sine : std::numeric_limits<double>::infinity(), polar_angle,
          pi * rim * rim * (1 + half_angle_tangent * half_angle_tangent)};
}

void require_volumes(double a, double b) {
  for (double volume : {a, b})
    if (!(std::isfinite(volume) && volume > 0))
      throw base::InputError("a bubble's volume has to be a finite number > 0; it is " + std::to_string(volume));
  if (!(std::max(a, b) <= largest_ratio * std::min(a, b)))
    throw base::InputError("the volumes of a double bubble may differ by a factor of 1e9 at most");
}

}  // namespace

DoubleBubbleEquilibrium double_bubble_equilibrium(double volume0, double volume1) {
  require_volumes(volume0, volume1);
  const bool swapped = volume0 > volume1;
  const double small = swapped ? volume1 : volume0, large = swapped ? volume0 : volume1;
  const double alpha = solve_alpha(small / large);
  HalfAngleTangents t(alpha);
  double theta = pi / 3 - 2 * alpha;
  if (small == large) t.wall = theta = 0;
  const double rim = std::cbrt((small + large) / (cap_volume(t.smaller) + cap_volume(t.larger)));
  DoubleBubbleEquilibrium e{
      {volume0, volume1},
      {film(t.smaller, third_of_a_turn - theta, rim), film(t.larger, third_of_a_turn + theta, rim)},
      film(t.wall, theta, rim),
      rim};
  if (swapped) std::swap(e.outer[0], e.outer[1]);
  return e;
}

}  // namespace foamsim
