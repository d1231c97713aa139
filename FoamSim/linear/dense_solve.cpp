#include "FoamSim/linear/dense_solve.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
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

double largest_eigenvalue(std::span<const double> diagonal, std::span<const double> beside) {
  using Values = Eigen::Map<const Eigen::VectorXd>;
  const Values main(diagonal.data(), static_cast<Eigen::Index>(diagonal.size()));
  const Values next(beside.data(), static_cast<Eigen::Index>(beside.size()));
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(main, next, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().maxCoeff();
}

}  // namespace foamsim
