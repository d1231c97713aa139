#include "FoamSim/dynamics/implicit_tension.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "Base/parallel/for_each.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

std::uint32_t entry_of_region(const SurfaceGeometry& geometry, Vertex v, lostopos::Region r) {
  const auto regions = geometry.regions(v);
  return static_cast<std::uint32_t>(geometry.first_entry(v)) +
         static_cast<std::uint32_t>(std::ranges::lower_bound(regions, r) - regions.begin());
}

}  // namespace

ImplicitTension::ImplicitTension(const CirculationKick& kick)
    : kick_(kick), curvature_(kick.step.mesh, kick.step.geometry) {
  number(kick);
  gather(kick);
  moved_.resize(kick.step.mesh.vertex_slots());
}

void ImplicitTension::number(const CirculationKick& kick) {
  const lostopos::SurfaceMesh& mesh = kick.step.mesh;
  first_.assign(mesh.vertex_slots() + 1, 0);
  for (std::size_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (const Vertex v(i); mesh.alive(v))
      for (const PairCirculation& held : kick.circulation.at(v)) {
        start_.push_back(held.value);
        sides_.push_back({entry_of_region(kick.step.geometry, v, held.pair.low),
                          entry_of_region(kick.step.geometry, v, held.pair.high)});
        free_.push_back(kick.step.is_held(v) ? 0 : 1);
      }
    first_[i + 1] = static_cast<std::uint32_t>(start_.size());
  }
}

void ImplicitTension::gather(const CirculationKick& kick) {
  gather_sheet(kick.step.mesh, kick.circulation, sheet_, kick.step.solid);
  corners_.resize(sheet_.size());
  for (std::size_t t = 0; t < sheet_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v = sheet_[t].vertices[k];
      const lostopos::Labels labels = kick.step.mesh.labels(sheet_[t].triangle);
      const auto values = std::as_const(kick.circulation).at(v);
      const auto at = std::ranges::lower_bound(values, RegionPair(labels), {}, &PairCirculation::pair);
      corners_[t][k] = {first_[v.index()] + static_cast<std::uint32_t>(at - values.begin()), RegionPair::sign(labels)};
    }
}

void ImplicitTension::displacements(const Eigen::VectorXd& values, std::vector<Vec3>& moved) const {
  for (std::size_t t = 0; t < sheet_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sheet_[t].circulation[k] = corners_[t][k].sign * values[static_cast<Eigen::Index>(corners_[t][k].entry)];
  kick_.velocity(sheet_, moved);
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] = kick_.step.is_held(Vertex(i)) ? Vec3(Vec3::Zero()) : Vec3(kick_.step.dt * moved[i]);
}

Eigen::VectorXd ImplicitTension::residual(const Eigen::VectorXd& change) {
  const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(start_.data(), size()) + change;
  displacements(values, moved_);
  const auto x = kick_.step.mesh.positions();
  positions_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) positions_[i] = x[i] + moved_[i];
  curvature_.evaluate(positions_, h_);
  Eigen::VectorXd residual = change;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (free_[i] != 0)
      residual[static_cast<Eigen::Index>(i)] -= kick_.step.dt * kick_.sigma * (h_[sides_[i][0]] - h_[sides_[i][1]]);
  return residual;
}

void ImplicitTension::linearise() {
  std::vector<Eigen::Triplet<double>> terms;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (free_[i] != 0) {
      terms.emplace_back(static_cast<int>(i), static_cast<int>(sides_[i][0]), 1.0);
      terms.emplace_back(static_cast<int>(i), static_cast<int>(sides_[i][1]), -1.0);
    }
  Row differences(size(), static_cast<Eigen::Index>(kick_.step.geometry.entries()));
  differences.setFromTriplets(terms.begin(), terms.end());
  pairs_ = differences * curvature_.derivative(positions_);
}

Eigen::VectorXd ImplicitTension::apply(const Eigen::VectorXd& v) const {
  displacements(v, moved_);
  const Eigen::Map<const Eigen::VectorXd> all(moved_.front().data(), static_cast<Eigen::Index>(3 * moved_.size()));
  return v - kick_.step.dt * kick_.sigma * (pairs_ * all);
}

// y·u with u = (1/4π) Σ γ × r / (r² + δ²)^{3/2} is Σ γ·Z, Z = (1/4π) Σ r × y / (r² + δ²)^{3/2}; γ is linear in Γ.
void ImplicitTension::add_adjoint(std::span<const std::uint32_t> vertices, std::span<const Vec3> y,
                                  Eigen::VectorXd& sum) const {
  const auto x = kick_.step.mesh.positions();
  const double delta_square = kick_.delta * kick_.delta;
  for (std::size_t t = 0; t < sheet_.size(); ++t) {
    const std::array<Vec3, 3> at = lostopos::corners(kick_.step.mesh, sheet_[t].triangle);
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3;
    Vec3 z = Vec3::Zero();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 r = x[vertices[i]] - middle;
      const double square = r.squaredNorm() + delta_square;
      if (square > 0) z += r.cross(y[i]) / (square * std::sqrt(square));
    }
    z /= 4 * std::numbers::pi;
    for (std::size_t k = 0; k < 3; ++k)
      sum[static_cast<Eigen::Index>(corners_[t][k].entry)] -=
          corners_[t][k].sign * (at[(k + 2) % 3] - at[(k + 1) % 3]).dot(z);
  }
}

Eigen::VectorXd ImplicitTension::apply_transposed(const Eigen::VectorXd& w) const {
  const Eigen::VectorXd pulled = pairs_.transpose() * w;
  std::vector<std::uint32_t> vertices;
  std::vector<Vec3> y;
  for (std::uint32_t v = 0; v < moved_.size(); ++v) {
    const Vec3 own = pulled.segment<3>(3 * static_cast<Eigen::Index>(v));
    if (own.isZero(0) || kick_.step.is_held(Vertex(v))) continue;
    vertices.push_back(v);
    y.push_back(own);
  }
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(size());
  add_adjoint(vertices, y, sum);
  return w - kick_.step.dt * kick_.step.dt * kick_.sigma * sum;
}

Eigen::VectorXd ImplicitTension::squared_rows() const {
  Eigen::VectorXd squares(size());
  base::parallel_for_each(static_cast<std::size_t>(size()), 8, [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i);
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3> y;
    for (Row::InnerIterator it(pairs_, row); it; ++it) {
      const auto v = static_cast<std::uint32_t>(it.col() / 3);
      if (kick_.step.is_held(Vertex(v))) continue;
      if (vertices.empty() || vertices.back() != v) {
        vertices.push_back(v);
        y.emplace_back(Vec3::Zero());
      }
      y.back()[it.col() % 3] = it.value();
    }
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(size());
    add_adjoint(vertices, y, sum);
    sum *= -kick_.step.dt * kick_.step.dt * kick_.sigma;
    sum[row] += 1;
    squares[row] = sum.squaredNorm();
  });
  return squares;
}

void ImplicitTension::add(const Eigen::VectorXd& change) const {
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
    if (first_[i] == first_[i + 1]) continue;
    const auto values = kick_.circulation.at(Vertex(i));
    for (std::size_t k = 0; k < values.size(); ++k) values[k].value += change[static_cast<Eigen::Index>(first_[i] + k)];
  }
}

}  // namespace foamsim
