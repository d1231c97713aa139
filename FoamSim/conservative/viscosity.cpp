#include "FoamSim/conservative/viscosity.h"

#include <algorithm>
#include <cmath>

#include "Base/parallel/for_each.h"
#include "FoamSim/conservative/vertex_vectors.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

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

// u' = u − dt S L u' with the response S. I + dt S L is symmetric and at least one in the product (v, w) = v·L w, and
// there its condition is mild.
int Viscosity::add_force(LocalResponse& response, double dt, std::span<const Vec3> velocity,
                         std::span<Vec3> force) const {
  constexpr double enough = 1e-9;
  Vectors lu, residual, l_residual, image, l_image;
  laplacian(velocity, lu);
  response.evaluate(lu, residual);
  for (Vec3& r : residual) r *= -dt;
  laplacian(residual, l_residual);
  Vectors direction = residual, l_direction = l_residual;
  double square = dot(residual, l_residual);
  const double goal = enough * enough * dot(velocity, lu);
  int iterations = 0;
  for (; iterations < most_iterations && square > goal; ++iterations) {
    response.evaluate(l_direction, image);
    laplacian(image, l_image);
    for (std::size_t v = 0; v < image.size(); ++v) {
      image[v] = direction[v] + dt * image[v];
      l_image[v] = l_direction[v] + dt * l_image[v];
    }
    const double step = square / dot(direction, l_image);
    add(lu, step, l_direction);
    add(residual, -step, image);
    add(l_residual, -step, l_image);
    const double next = dot(residual, l_residual);
    const double turn = next / square;
    for (std::size_t v = 0; v < direction.size(); ++v) {
      direction[v] = residual[v] + turn * direction[v];
      l_direction[v] = l_residual[v] + turn * l_direction[v];
    }
    square = next;
  }
  add(force, 1, lu);
  return iterations;
}

}  // namespace foamsim
