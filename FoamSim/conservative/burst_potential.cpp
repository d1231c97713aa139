#include "FoamSim/conservative/burst_potential.h"

#include <algorithm>
#include <limits>

#include "FoamSim/linear/dense_solve.h"

namespace foamsim {

using lostopos::air;
using lostopos::Region;
using lostopos::Vec3;

namespace {

constexpr std::size_t no_entry = std::numeric_limits<std::size_t>::max();

std::size_t entry_at(const FilmConnectivity& films, std::size_t v, Region r) {
  for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
    if (films.regions[e] == r) return e;
  return no_entry;
}

// A third of the area of the films that a region has at v, those towards `other` left out.
double film_area_at(const FilmConnectivity& films, const FilmShape& shape, std::size_t v, Region region, Region other) {
  double sum = 0;
  for (std::uint32_t corner : films.around(v)) {
    const std::size_t t = corner / 3, k = corner % 3;
    const Region p = films.regions[films.front[t][k]], q = films.regions[films.back[t][k]];
    if ((p == region && q != other) || (q == region && p != other)) sum += shape.area[t] / 3;
  }
  return sum;
}

}  // namespace

BurstPotential::BurstPotential(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi,
                               Region bursting) {
  find_border(films, shape, phi, bursting);
  join(films, phi, bursting);
  std::vector<double> shifted(phi.begin(), phi.end());
  for (std::size_t e = 0; e < shifted.size(); ++e)
    if (films.regions[e] == bursting) shifted[e] += level_;
  kept_ = kept(films, shape, shifted, bursting);
}

void BurstPotential::find_border(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi,
                                 Region bursting) {
  border_.assign(films.vertex_slots(), {});
  double sum = 0, weight = 0;
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    const std::size_t own = entry_at(films, v, bursting), outside = entry_at(films, v, air);
    if (own == no_entry || outside == no_entry) continue;
    border_[v] = {film_area_at(films, shape, v, air, bursting), film_area_at(films, shape, v, bursting, air)};
    sum += border_[v].area() * (phi[outside] - phi[own]);
    weight += border_[v].area();
  }
  level_ = weight > 0 ? sum / weight : 0;
}

void BurstPotential::join(const FilmConnectivity& films, std::span<const double> phi, Region bursting) {
  joined_.assign(films.vertex_slots(), 0.0);
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    const std::size_t own = entry_at(films, v, bursting), outside = entry_at(films, v, air);
    if (const Border& border = border_[v]; border.area() > 0)
      joined_[v] = (border.outside * phi[outside] + border.inside * (phi[own] + level_)) / border.area();
    else if (own != no_entry)
      joined_[v] = phi[own] + level_;
    else if (outside != no_entry)
      joined_[v] = phi[outside];
  }
}

BurstPotential::Kept BurstPotential::kept(const FilmConnectivity& films, const FilmShape& shape,
                                          std::span<const double> phi, Region second) {
  Kept kept;
  const auto is_air = [second](Region r) { return r == air || r == second; };
  for (std::size_t t = 0; t < films.corners.size(); ++t) {
    const Region p = films.regions[films.front[t][0]], q = films.regions[films.back[t][0]];
    if (is_air(p) && is_air(q)) continue;
    double mean = 0;
    for (std::size_t k = 0; k < 3; ++k) mean += (phi[films.front[t][k]] - phi[films.back[t][k]]) / 3;
    kept.impulse += 2 * mean * shape.area_vector[t];
    if (is_air(p)) kept.integrals[q] += mean * shape.area[t];
    if (is_air(q)) kept.integrals[p] -= mean * shape.area[t];
  }
  return kept;
}

void BurstPotential::finish(const FilmConnectivity& films, const FilmShape& shape, std::span<double> phi) const {
  for (std::size_t v = 0; v < films.vertex_slots(); ++v)
    if (const std::size_t outside = entry_at(films, v, air); outside != no_entry) phi[outside] = joined_[v];
  change_border(films, shape, phi);
}

void BurstPotential::change_border(const FilmConnectivity& films, const FilmShape& shape, std::span<double> phi) const {
  const Kept now = kept(films, shape, phi, air);
  // Rows: the impulse, and the integrals over films that the border touches; columns: the border's vertices.
  std::vector<std::size_t> vertices;
  std::map<Region, Eigen::Index> rows;
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    if (!(border_[v].area() > 0) || films.held[v] != 0 || entry_at(films, v, air) == no_entry) continue;
    vertices.push_back(v);
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      if (films.regions[e] != air) rows.try_emplace(films.regions[e], 0);
  }
  Eigen::Index row = 3;
  for (auto& [region, own] : rows) own = row++;
  if (vertices.empty()) return;
  Eigen::VectorXd missing(row);
  missing.head<3>() = kept_.impulse - now.impulse;
  const auto value = [](const std::map<Region, double>& of, Region r) { return of.contains(r) ? of.at(r) : 0.0; };
  for (const auto& [region, own] : rows) missing[own] = value(kept_.integrals, region) - value(now.integrals, region);
  // In unknowns times the root of the area, so that the least norm is the least mean square.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(row, static_cast<Eigen::Index>(vertices.size()));
  std::vector<double> roots;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const std::size_t v = vertices[i];
    roots.push_back(std::sqrt(film_area_at(films, shape, v, air, air)));
    matrix.col(column).head<3>() = 2 / roots[i] * shape.region_gradient[entry_at(films, v, air)];
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      const Region p = films.regions[films.front[t][k]], q = films.regions[films.back[t][k]];
      if (p == air) matrix(rows.at(q), column) += shape.area[t] / 3 / roots[i];
      if (q == air) matrix(rows.at(p), column) += shape.area[t] / 3 / roots[i];
    }
  }
  const Eigen::VectorXd change = least_squares(matrix, missing);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    phi[entry_at(films, vertices[i], air)] += change[static_cast<Eigen::Index>(i)] / roots[i];
}

}  // namespace foamsim
