#include "FoamSim/conservative/viscosity.h"

#include <algorithm>
#include <cmath>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// In the order of the entries, on one thread: the same bits always.
double dot(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

void add(std::span<Vec3> to, double factor, std::span<const Vec3> what) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * what[i];
}

}  // namespace

void Viscosity::connect(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  first_.assign(mesh.vertex_slots() + 1, 0);
  neighbours_.clear();
  for (std::size_t slot = 0; slot < mesh.vertex_slots(); ++slot) {
    const Vertex v(static_cast<std::uint32_t>(slot));
    if (mesh.alive(v))
      for (Edge e : mesh.edges(v)) {
        const auto films = std::ranges::count_if(mesh.triangles(e), [&](Triangle t) { return !is_solid(t, solid); });
        if (films > 0)
          neighbours_.push_back(
              {mesh.other_vertex(e, v).index(), coefficient_ * static_cast<double>(films) / (2 * std::sqrt(3.0))});
      }
    first_[slot + 1] = static_cast<std::uint32_t>(neighbours_.size());
  }
}

void Viscosity::laplacian(std::span<const Vec3> u, Vectors& out) const {
  out.resize(u.size());
  base::parallel_for_each(u.size(), film_grain, [&](std::size_t v) {
    Vec3 sum = Vec3::Zero();
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i)
      sum += neighbours_[i].weight * (u[v] - u[neighbours_[i].vertex]);
    out[v] = sum;
  });
}

void Viscosity::response(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                         std::span<const Vec3> force, Vectors& velocity) {
  pressure_.resize(films.entries());
  balance(films, shape, force, pressure_);
  // A film's symbol is at most about h̄/2 for the waves that a mesh carries.
  const double least_area = 0.3 * std::sqrt(3.0) / 4 * resolution_ * resolution_;
  potential_.resize(films.corners.size());
  base::parallel_for_each(films.corners.size(), film_grain, [&](std::size_t t) {
    Vec3 strength = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      strength -=
          (pressure_[films.front[t][k]] - pressure_[films.back[t][k]]) / 2 * opposite_edge(films, t, k, positions);
    potential_[t] = resolution_ / 2 / std::max(shape.area[t], least_area) * strength;
  });
  collect_fluxes(films, positions, potential_, flux_);
  const Vectors still(films.vertex_slots(), Vec3::Zero());
  velocity.resize(films.vertex_slots());
  fit_velocities(films, shape, flux_, still, velocity);
}

// u' = u + dt S L u' with the response S (negative: a force ∂R/∂u slows down); L times that is symmetric:
// (L − dt L S L) u' = L u.
void Viscosity::add_force(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> positions,
                          double dt, std::span<const Vec3> velocity, std::span<Vec3> force) {
  constexpr int most_iterations = 60;
  constexpr double enough = 1e-6;
  Vectors u(velocity.begin(), velocity.end()), lu, slu, image, residual, direction;
  const auto apply = [&](const Vectors& of, Vectors& out) {
    laplacian(of, lu);
    response(films, shape, positions, lu, slu);
    laplacian(slu, out);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = lu[v] - dt * out[v];
  };
  Vectors right;
  laplacian(velocity, right);
  apply(u, image);
  residual = right;
  add(residual, -1, image);
  direction = residual;
  double square = dot(residual, residual);
  const double goal = enough * enough * dot(right, right);
  for (int i = 0; i < most_iterations && square > goal; ++i) {
    apply(direction, image);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) break;
    add(u, square / curvature, direction);
    add(residual, -square / curvature, image);
    const double next = dot(residual, residual);
    for (std::size_t v = 0; v < direction.size(); ++v) direction[v] = residual[v] + next / square * direction[v];
    square = next;
  }
  laplacian(u, lu);
  add(force, 1, lu);
}

}  // namespace foamsim
