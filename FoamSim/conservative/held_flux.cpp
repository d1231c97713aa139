#include "FoamSim/conservative/held_flux.h"

#include <cmath>

#include "Base/lists/erase_repeated.h"
#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void HeldFlux::update(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                      std::span<const std::uint8_t> driven) {
  films_ = &films;
  shape_ = &shape;
  positions_ = positions;
  vertices_.clear();
  entries_.clear();
  triangles_.clear();
  for (std::uint32_t v = 0; v < films.vertex_slots(); ++v) {
    if (driven[v] == 0 || films.around(v).empty()) continue;
    vertices_.push_back(v);
    for (std::uint32_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) entries_.push_back(e);
    for (std::uint32_t corner : films.around(v)) triangles_.push_back(corner / 3);
  }
  base::sort_unique(triangles_);
  sources_.resize(triangles_.size());
  all_phi_.assign(films.entries(), 0.0);
  flux_.assign(films.entries(), 0.0);
  strength_.assign(films.corners.size(), Vec3::Zero());
}

void HeldFlux::apply(std::span<const double> phi, std::vector<double>& out) {
  const FilmConnectivity& films = *films_;
  for (std::size_t i = 0; i < entries_.size(); ++i) all_phi_[entries_[i]] = phi[i];
  base::parallel_for_each(triangles_.size(), film_grain, [&](std::size_t i) {
    const std::size_t t = triangles_[i];
    Vec3 gamma = Vec3::Zero(), middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      gamma -= (all_phi_[films.front[t][k]] - all_phi_[films.back[t][k]]) * opposite_edge(films, t, k, positions_);
      middle += positions_[films.corners[t][k]];
    }
    strength_[t] = gamma;
    sources_.set(i, middle / 3, gamma);
  });
  direct_.evaluate(sources_, delta_, PairTerms::potential, sums_);
  potential_.assign(films.corners.size(), Vec3::Zero());
  for (std::size_t i = 0; i < triangles_.size(); ++i) potential_[triangles_[i]] = sums_.potential[i];
  near_.add_potential(films, *shape_, strength_, potential_);
  base::parallel_for_each(vertices_.size(), film_grain, [&](std::size_t i) {
    const std::uint32_t v = vertices_[i];
    for (std::uint32_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) flux_[e] = 0;
    for (std::uint32_t corner : films.around(v)) {
      const std::size_t t = corner / 3, k = corner % 3;
      const double part = 0.5 * opposite_edge(films, t, k, positions_).dot(potential_[t]);
      flux_[films.front[t][k]] += part;
      flux_[films.back[t][k]] -= part;
    }
  });
  out.resize(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) out[i] = -flux_[entries_[i]];
}

long HeldFlux::solve(std::span<const double> flux, std::span<const Vec3> velocity, std::span<double> phi) {
  constexpr double negligible = 1e-7;
  const std::size_t n = entries_.size();
  std::vector<double> residual, change(n, 0.0), product_of;
  double scale = 0;
  for (std::uint32_t v : vertices_)
    for (std::uint32_t e = films_->first_entry[v]; e < films_->first_entry[v + 1]; ++e) {
      const double wanted = shape_->region_gradient[e].dot(velocity[v]);
      residual.push_back(flux[e] - wanted);
      scale += wanted * wanted + flux[e] * flux[e];
    }
  std::vector<double> direction = residual;
  double square = product(residual, residual);
  long iterations = 0;
  for (; square > negligible * negligible * scale && iterations < most_iterations; ++iterations) {
    apply(direction, product_of);
    const double curvature = product(direction, product_of);
    if (!(curvature > 0)) break;
    const double step = square / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      change[i] += step * direction[i];
      residual[i] -= step * product_of[i];
    }
    const double next = product(residual, residual);
    for (std::size_t i = 0; i < n; ++i) direction[i] = residual[i] + next / square * direction[i];
    square = next;
  }
  for (std::size_t i = 0; i < n; ++i) phi[entries_[i]] += change[i];
  return iterations;
}

}  // namespace foamsim
