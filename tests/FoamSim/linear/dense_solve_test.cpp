#include "FoamSim/linear/dense_solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foamsim {
namespace {

// Films a, b and c at a point of the regions 0, 1 and 2: the jumps 0-1, 1-2 and 0-2, the third being the sum of the
// others.
Eigen::MatrixXd jumps() {
  Eigen::MatrixXd a(3, 3);
  a << 1, -1, 0,  //
      0, 1, -1,   //
      1, 0, -1;
  return a;
}

TEST(DenseSolve, LeastSquaresOfDeficientRankAreTheShortest) {
  const Eigen::Vector3d b(1, 2, 5);  // no x has all three: 1 + 2 is not 5
  const Eigen::VectorXd x = least_squares(jumps(), b);
  EXPECT_LT((jumps().transpose() * (jumps() * x - b)).norm(), 1e-14);
  EXPECT_LT(std::abs(x.sum()), 1e-14);  // nothing of (1, 1, 1), which A does not see
}

TEST(DenseSolve, LeastSquaresWithMoreUnknownsThanEquations) {
  Eigen::MatrixXd a(1, 2);
  a << 3, 4;
  const Eigen::VectorXd x = least_squares(a, Eigen::VectorXd::Constant(1, 50));
  EXPECT_LT((x - Eigen::Vector2d(6, 8)).norm(), 1e-13);
}

TEST(DenseSolve, SymmetricDefinite) {
  Eigen::MatrixXd a(3, 3);
  a << 4, 1, 0,  //
      1, 3, -1,  //
      0, -1, 2;
  const Eigen::Vector3d x(1, -2, 3);
  EXPECT_LT((solve_symmetric(a, a * x) - x).norm(), 1e-14);
}

TEST(DenseSolve, ProjectionLeavesWhatClosesAndIsOne) {
  const auto projection = projection_onto_range(jumps());
  ASSERT_TRUE(projection);
  EXPECT_LT((*projection * *projection - *projection).norm(), 1e-14);
  EXPECT_LT((*projection - projection->transpose()).norm(), 1e-14);
  EXPECT_LT((*projection * jumps() - jumps()).norm(), 1e-14);
  // 1, 2 and 5 do not close by 2; the nearest that do share it out.
  EXPECT_LT((*projection * Eigen::Vector3d(1, 2, 5) - Eigen::Vector3d(1 + 2. / 3, 2 + 2. / 3, 5 - 2. / 3)).norm(),
            1e-13);
  EXPECT_FALSE(projection_onto_range(Eigen::MatrixXd::Identity(2, 2)));
}

// Second differences of n values: 2 − 2 cos(π n/(n + 1)).
TEST(DenseSolve, LargestEigenvalueOfSecondDifferences) {
  for (const std::size_t n : {1U, 2U, 7U}) {
    const std::vector<double> diagonal(n, 2), beside(n - 1, -1);
    const double exact = 2 - 2 * std::cos(std::numbers::pi * static_cast<double>(n) / static_cast<double>(n + 1));
    EXPECT_NEAR(largest_eigenvalue(diagonal, beside), exact, 1e-14);
  }
}

}  // namespace
}  // namespace foamsim
