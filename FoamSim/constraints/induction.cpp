#include "FoamSim/constraints/induction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Enough for the threads of a workstation; sums of groups are added up in their order.
constexpr std::size_t most_row_groups = 16;

}  // namespace

Induction::Induction(std::vector<InductionTarget> targets, const std::vector<InductionSource>& sources,
                     std::size_t unknowns, double delta, double factor, std::size_t bytes)
    : targets_(std::move(targets)),
      unknowns_(unknowns),
      delta_(delta),
      scale_(factor * std::numbers::inv_pi / 4),
      x_(static_cast<Eigen::Index>(sources.size())),
      y_(x_.size()),
      z_(x_.size()),
      first_part_{0} {
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const auto i = static_cast<Eigen::Index>(s);
    x_[i] = sources[s].point.x();
    y_[i] = sources[s].point.y();
    z_[i] = sources[s].point.z();
    parts_.insert(parts_.end(), sources[s].parts.begin(), sources[s].parts.begin() + sources[s].count);
    first_part_.push_back(parts_.size());
  }
  if (rows() * unknowns_ * sizeof(double) > bytes) return;
  kept_.resize(static_cast<Eigen::Index>(rows()), static_cast<Eigen::Index>(unknowns_));
  base::parallel_for_each(rows(), 16, [this](std::size_t i) {
    fill_row(i, {kept_.data() + i * unknowns_, unknowns_});
  });
}

// [γ × d]·n = γ·(d × n)
void Induction::fill_row(std::size_t i, std::span<double> row) const {
  const Vec3 &x = targets_[i].point, &n = targets_[i].normal;
  const Eigen::ArrayXd dx = x.x() - x_, dy = x.y() - y_, dz = x.z() - z_;
  const Eigen::ArrayXd square = dx.square() + dy.square() + dz.square() + delta_ * delta_;
  const Eigen::ArrayXd over = scale_ / (square * square.sqrt());
  const Eigen::ArrayXd gx = over * (dy * n.z() - dz * n.y()), gy = over * (dz * n.x() - dx * n.z()),
                       gz = over * (dx * n.y() - dy * n.x());
  std::ranges::fill(row, 0.0);
  for (std::size_t s = 0; s + 1 < first_part_.size(); ++s) {
    const auto k = static_cast<Eigen::Index>(s);
    for (std::size_t p = first_part_[s]; p < first_part_[s + 1]; ++p) {
      const Vec3& strength = parts_[p].strength;
      row[parts_[p].unknown] += strength.x() * gx[k] + strength.y() * gy[k] + strength.z() * gz[k];
    }
  }
}

std::size_t Induction::groups() const {
  return std::clamp<std::size_t>(rows() / 8, 1, most_row_groups);
}

template <class What>
void Induction::for_rows(const What& what) const {
  const std::size_t count = groups();
  base::parallel_for_each(count, 1, [&](std::size_t group) {
    std::vector<double> made(kept_.size() > 0 ? 0 : unknowns_);
    for (std::size_t i = group * rows() / count; i < (group + 1) * rows() / count; ++i) {
      if (kept_.size() == 0) fill_row(i, made);
      const double* row = kept_.size() > 0 ? kept_.data() + i * unknowns_ : made.data();
      what(group, i, Eigen::Map<const Eigen::VectorXd>(row, static_cast<Eigen::Index>(unknowns_)));
    }
  });
}

Eigen::VectorXd Induction::apply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(static_cast<Eigen::Index>(rows()));
  for_rows([&](std::size_t, std::size_t i, const auto& row) { y[static_cast<Eigen::Index>(i)] = row.dot(x); });
  return y;
}

Eigen::VectorXd Induction::transposed(const Eigen::VectorXd& y) const {
  std::vector<Eigen::VectorXd> sums(groups(), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_)));
  for_rows(
      [&](std::size_t group, std::size_t i, const auto& row) { sums[group] += y[static_cast<Eigen::Index>(i)] * row; });
  for (std::size_t group = 1; group < sums.size(); ++group) sums[0] += sums[group];
  return sums[0];
}

// Each row is used for both products while it is at hand.
Eigen::VectorXd Induction::normal_product(const Eigen::VectorXd& x, double weight) const {
  std::vector<Eigen::VectorXd> sums(groups(), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_)));
  for_rows([&](std::size_t group, std::size_t, const auto& row) { sums[group] += row.dot(x) * row; });
  Eigen::VectorXd product = weight * weight * x;
  for (const Eigen::VectorXd& sum : sums) product += sum;
  return product;
}

Induction::Solution Induction::solve(const Eigen::VectorXd& b, double weight, const Projection& projection) const {
  constexpr double negligible = 1e-9;
  Solution solution{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_)), 0};
  Eigen::VectorXd residual = transposed(b);
  if (projection) projection(residual);
  Eigen::VectorXd direction = residual;
  double square = residual.squaredNorm();
  const double enough = negligible * negligible * square;
  for (; square > enough && solution.iterations < most_iterations; ++solution.iterations) {
    Eigen::VectorXd product = normal_product(direction, weight);
    if (projection) projection(product);
    const double step = square / direction.dot(product);
    solution.x += step * direction;
    residual -= step * product;
    const double next = residual.squaredNorm();
    direction = residual + next / square * direction;
    square = next;
  }
  return solution;
}

}  // namespace foamsim
