#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "FoamSim/sheet/velocity/vortex_sources.h"

namespace foamsim {

/// A point vortex whose strength depends on up to three unknowns: Σ strength of each × unknown.
struct InductionSource {
  struct Part {
    std::uint32_t unknown = 0;
    lostopos::Vec3 strength = lostopos::Vec3::Zero();  ///< vorticity for one unit of the unknown
  };
  lostopos::Vec3 point;  ///< L
  std::array<Part, 3> parts = {};
  std::size_t count = 0;  ///< of parts that are used
};

/// A point and a direction in which velocity is prescribed there.
struct InductionTarget {
  lostopos::Vec3 point;  ///< L
  lostopos::Vec3 normal;
};

/// How unknown strengths move points along given directions: the matrix
///
///   M_ij = factor/(4π) Σ [strength of j in s × (x_i − m_s)]·n_i / (|x_i − m_s|² + δ²)^{3/2}
///
/// over the sources s (the regularised Biot–Savart law), and the regularised least squares in which the wires' solves
/// end. Rows are kept where they take less than `most_bytes`, else they are made anew in every round of the iteration,
/// so that memory stays proportional to sources and targets. Same bits for any number of threads.
class Induction {
 public:
  static constexpr std::size_t most_bytes = std::size_t{1} << 28U;

  /// `delta`: δ, L.
  Induction(std::vector<InductionTarget> targets, const std::vector<InductionSource>& sources, std::size_t unknowns,
            double delta, double factor, std::size_t bytes = most_bytes);

  std::size_t rows() const { return targets_.size(); }
  std::size_t unknowns() const { return unknowns_; }

  struct Solution {
    Eigen::VectorXd x;
    long iterations = 0;  ///< `most_iterations`: it was not solved in full
  };
  static constexpr long most_iterations = 400;
  /// An orthogonal projection of unknowns, made in place, on the space that they may be in; empty: all of it.
  using Projection = std::function<void(Eigen::VectorXd&)>;
  /// The x in that space that makes |M x − b|² + weight² |x|² least, (MᵀM + weight² I)⁻¹ Mᵀ b for all of it, by
  /// conjugate gradients to nine digits. `weight` > 0.
  Solution solve(const Eigen::VectorXd& b, double weight, const Projection& projection = {}) const;

  /// M x.
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  void fill_row(std::size_t i, std::span<double> row) const;
  // Calls what(i, row) for all rows, those of a group one after the other.
  template <class What>
  void for_rows(const What& what) const;
  std::size_t groups() const;
  // MᵀM x + weight² x
  Eigen::VectorXd normal_product(const Eigen::VectorXd& x, double weight) const;
  Eigen::VectorXd transposed(const Eigen::VectorXd& y) const;

  std::vector<InductionTarget> targets_;
  std::size_t unknowns_;
  double delta_, scale_;
  Eigen::ArrayXd x_, y_, z_;             // of the sources
  std::vector<std::size_t> first_part_;  // by source + 1
  std::vector<InductionSource::Part> parts_;
  Rows kept_;
};

}  // namespace foamsim
