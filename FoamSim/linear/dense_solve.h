#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace foamsim {

// Eigen's dense decompositions, compiled once: a source that has its own takes 3 to 12 s longer to compile.

/// The shortest x among those with the least |A x − b|, whatever A's rank (complete orthogonal decomposition).
/// a: m × n; b: m. Returns n values.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The x with A x = b (Cholesky decomposition L D Lᵀ with pivots). a: n × n, symmetric and definite; b: n.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The orthogonal projection onto what A x can be (m × m); nothing where that is all there is, A's rank being m.
/// a: m × n.
std::optional<Eigen::MatrixXd> projection_onto_range(const Eigen::MatrixXd& a);

/// The largest eigenvalue of the symmetric tridiagonal matrix with this diagonal (n > 0 values) and these n − 1 values
/// beside it.
double largest_eigenvalue(std::span<const double> diagonal, std::span<const double> beside);

}  // namespace foamsim
