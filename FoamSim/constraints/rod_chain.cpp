#include "FoamSim/constraints/rod_chain.h"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>
#include <numbers>

#include "LosTopos/error.h"

namespace foamsim {

using Eigen::Matrix3d;
using lostopos::Vec3;

namespace {

// Of closed chains' drag.
constexpr double closed_drag = 1e-4;
// |cross product|² below which a triangle of film has no direction to pull in, L⁴.
constexpr double least_cross_square = 1e-24;

Eigen::Index row(std::size_t vertex) {
  return 3 * static_cast<Eigen::Index>(vertex);
}

class BlockList {
 public:
  void add(std::size_t i, std::size_t j, const Matrix3d& block) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        entries_.emplace_back(static_cast<int>(row(i)) + a, static_cast<int>(row(j)) + b, block(a, b));
  }
  Eigen::SparseMatrix<double> matrix(std::size_t vertices) const {
    Eigen::SparseMatrix<double> matrix(row(vertices), row(vertices));
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

 private:
  std::vector<Eigen::Triplet<double>> entries_;
};

Matrix3d cross_matrix(const Vec3& e) {
  Matrix3d m;
  m << 0, -e.z(), e.y(), e.z(), 0, -e.x(), -e.y(), e.x(), 0;
  return m;
}

}  // namespace

RodChain::RodChain(std::vector<double> lengths, bool closed, std::vector<char> fixed, const RodMaterial& material)
    : lengths_(std::move(lengths)),
      fixed_(std::move(fixed)),
      material_(material),
      mass_(fixed_.size(), 0.0),
      drag_(fixed_.size(), 0.0) {
  const std::size_t n = size();
  const double over_length = std::numbers::pi * material.radius * material.radius * material.density;
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    for (std::size_t end : {i, after(i)}) mass_[end] += over_length * lengths_[i] / 2;
  const double beta = material.bending * material.damping * (closed ? closed_drag : 1.0);
  for (std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const std::size_t before = i > 0 ? i - 1 : n - 1;
    const double a = lengths_[before], b = lengths_[i];
    const Bend bend{before, i, after(i), (a + b) / (2 * a), (a + b) / (2 * b)};
    bends_.push_back(bend);
    drag_[bend.before] += beta * bend.c1 * bend.c1;
    drag_[bend.at] += beta * (bend.c1 + bend.c2) * (bend.c1 + bend.c2);
    drag_[bend.behind] += beta * bend.c2 * bend.c2;
  }
}

double RodChain::energy(std::span<const Vec3> x, double pull, std::span<const RodFilm> films) const {
  double sum = 0;
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const double longer = (x[after(i)] - x[i]).norm() - lengths_[i];
    sum += 0.5 * material_.stretching * longer * longer;
  }
  for (const Bend& b : bends_)
    sum += 0.5 * material_.bending * ((b.c1 + b.c2) * x[b.at] - b.c1 * x[b.before] - b.c2 * x[b.behind]).squaredNorm();
  for (std::size_t i = 0; i < size(); ++i) sum += mass_[i] * material_.gravity * x[i].z();
  for (const RodFilm& film : films) {
    const Vec3 cross = (film.c - film.b).cross(x[film.vertex] - film.b);
    if (cross.squaredNorm() >= least_cross_square) sum += pull * cross.norm() / 2;
  }
  return sum;
}

Eigen::VectorXd RodChain::gradient(std::span<const Vec3> x, double pull, std::span<const RodFilm> films) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(row(size()));
  const auto at = [&sum](std::size_t i) { return sum.segment<3>(row(i)); };
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const Vec3 d = x[after(i)] - x[i];
    const double length = d.norm();
    if (!(length > 0)) continue;
    const Vec3 force = material_.stretching * (1 - lengths_[i] / length) * d;
    at(i) -= force;
    at(after(i)) += force;
  }
  for (const Bend& b : bends_) {
    const Vec3 force = material_.bending * ((b.c1 + b.c2) * x[b.at] - b.c1 * x[b.before] - b.c2 * x[b.behind]);
    at(b.before) -= b.c1 * force;
    at(b.at) += (b.c1 + b.c2) * force;
    at(b.behind) -= b.c2 * force;
  }
  for (std::size_t i = 0; i < size(); ++i) at(i).z() += mass_[i] * material_.gravity;
  for (const RodFilm& film : films) {
    const Vec3 edge = film.c - film.b, cross = edge.cross(x[film.vertex] - film.b);
    if (cross.squaredNorm() >= least_cross_square) at(film.vertex) += pull / 2 * cross.normalized().cross(edge);
  }
  return sum;
}

Eigen::SparseMatrix<double> RodChain::hessian(std::span<const Vec3> x, double pull, std::span<const RodFilm> films,
                                              bool positive) const {
  BlockList blocks;
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const std::size_t j = after(i);
    const Vec3 d = x[j] - x[i];
    const double length = d.norm();
    if (!(length > 0)) continue;
    const Vec3 t = d / length;
    const double across = positive ? std::max(0.0, 1 - lengths_[i] / length) : 1 - lengths_[i] / length;
    const Matrix3d along = t * t.transpose();
    const Matrix3d block = material_.stretching * (across * (Matrix3d::Identity() - along) + along);
    blocks.add(i, i, block);
    blocks.add(j, j, block);
    blocks.add(i, j, -block);
    blocks.add(j, i, -block);
  }
  for (const Bend& b : bends_) {
    const std::array<std::pair<std::size_t, double>, 3> parts{
        {{b.before, -b.c1}, {b.at, b.c1 + b.c2}, {b.behind, -b.c2}}};
    for (const auto& [i, ci] : parts)
      for (const auto& [j, cj] : parts) blocks.add(i, j, material_.bending * ci * cj * Matrix3d::Identity());
  }
  for (const RodFilm& film : films) {
    const Matrix3d edge = cross_matrix(film.c - film.b);
    const Vec3 cross = edge * (x[film.vertex] - film.b);
    if (cross.squaredNorm() < least_cross_square) continue;
    const double size = cross.norm();
    const Vec3 slope = edge.transpose() * cross / size;
    blocks.add(film.vertex, film.vertex, pull / (2 * size) * (edge.transpose() * edge - slope * slope.transpose()));
  }
  return blocks.matrix(size());
}

void RodChain::advance(double dt, RodScheme scheme, double pull, std::span<const RodFilm> films, Points& x,
                       Points& v) const {
  const bool reference = scheme == RodScheme::reference;
  Points at = x;
  Eigen::VectorXd velocity(row(size())), mass_and_drag(row(size())), drag(row(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    if (reference) at[i] += dt * v[i];
    velocity.segment<3>(row(i)) = v[i];
    drag.segment<3>(row(i)).setConstant(drag_[i]);
    mass_and_drag.segment<3>(row(i)).setConstant(mass_[i] + dt * drag_[i]);
  }
  const Eigen::SparseMatrix<double> stiffness = hessian(x, pull, films, !reference);
  Eigen::VectorXd right = -gradient(at, pull, films) - drag.cwiseProduct(velocity) - dt * (stiffness * velocity);
  right *= dt;
  Eigen::SparseMatrix<double> matrix = dt * dt * stiffness;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += mass_and_drag[i];
  for (int column = 0; column < matrix.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
      if (fixed_[static_cast<std::size_t>(it.row()) / 3] != 0 || fixed_[static_cast<std::size_t>(it.col()) / 3] != 0)
        it.valueRef() = it.row() == it.col() ? 1 : 0;
  for (std::size_t i = 0; i < size(); ++i)
    if (fixed_[i] != 0) right.segment<3>(row(i)).setZero();
  matrix.makeCompressed();
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
  solver.compute(matrix);
  const Eigen::VectorXd change = solver.info() == Eigen::Success ? Eigen::VectorXd(solver.solve(right)) : right;
  if (solver.info() != Eigen::Success || !change.allFinite())
    throw lostopos::MotionError(
        "the rod's step cannot be solved: its system is singular; a smaller dt makes it less so");
  for (std::size_t i = 0; i < size(); ++i) {
    if (fixed_[i] != 0) {
      v[i].setZero();
      continue;
    }
    v[i] += change.segment<3>(row(i));
    x[i] += dt * v[i];
  }
}

}  // namespace foamsim
