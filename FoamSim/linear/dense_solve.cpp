#include "FoamSim/linear/dense_solve.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace foamsim {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.ldlt().solve(b);
}

std::optional<Eigen::MatrixXd> projection_onto_range(const Eigen::MatrixXd& a) {
  const auto decomposition = a.completeOrthogonalDecomposition();
  if (decomposition.rank() == a.rows()) return std::nullopt;
  return Eigen::MatrixXd(a * decomposition.pseudoInverse());
}

}  // namespace foamsim
