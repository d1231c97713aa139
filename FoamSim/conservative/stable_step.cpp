#include "FoamSim/conservative/stable_step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// ω of a lattice of vertices over that of one: on regular triangles both Laplacians have 1.5 times their diagonal at
// most.
constexpr double lattice = 1.5;

Vec3 barycentre(const FilmConnectivity& films, std::size_t t, std::span<const Vec3> x) {
  const auto& [a, b, c] = films.corners[t];
  return (x[a] + x[b] + x[c]) / 3;
}

// Squared angular frequency of v alone: u̇ = −¼ A⁺ M A⁺ᵀ H x with A⁺ = G⁺ Σ a; bounded by the trace.
double squared_frequency(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> x, std::size_t v,
                         double tension, double delta) {
  const auto around = films.around(v);
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (std::uint32_t corner : around) {
    const std::size_t t = corner / 3;
    if (!(shape.area[t] > 0)) continue;
    const Vec3 normal = shape.area_vector[t] / shape.area[t];
    stiffness += tension * opposite_edge(films, t, corner % 3, x).squaredNorm() / (4 * shape.area[t]) * normal *
                 normal.transpose();
  }
  // γ of each triangle for unit φ, mapped to a force: γ_t = −opp (a^p − a^q)·G⁺ F.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::uint32_t i : around)
    for (std::uint32_t j : around) {
      const std::size_t s = i / 3, t = j / 3;
      const Vec3 ds = shape.region_gradient[films.front[s][i % 3]] - shape.region_gradient[films.back[s][i % 3]];
      const Vec3 dt = shape.region_gradient[films.front[t][j % 3]] - shape.region_gradient[films.back[t][j % 3]];
      const double distance =
          std::sqrt((barycentre(films, s, x) - barycentre(films, t, x)).squaredNorm() + delta * delta);
      inertia += opposite_edge(films, s, i % 3, x).dot(opposite_edge(films, t, j % 3, x)) *
                 (std::numbers::inv_pi / 4 / distance) * ds * dt.transpose();
    }
  const Eigen::Matrix3d mapped = shape.map[v] * inertia * shape.map[v];
  return std::max(0.0, (mapped * stiffness).trace() / 4);
}

}  // namespace

double stable_step(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                   double tension, double delta) {
  std::vector<double> squares(films.vertex_slots(), 0.0);
  base::parallel_for_each(films.vertex_slots(), 64, [&](std::size_t v) {
    squares[v] = squared_frequency(films, shape, positions, v, tension, delta);
  });
  const double largest = squares.empty() ? 0.0 : *std::ranges::max_element(squares);
  return largest > 0 ? 2 / (lattice * std::sqrt(largest)) : std::numeric_limits<double>::infinity();
}

}  // namespace foamsim
