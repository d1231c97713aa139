#include "FoamSim/dynamics/implicit.h"

#include <limits>
#include <unsupported/Eigen/IterativeSolvers>

#include "Base/error.h"
#include "FoamSim/dynamics/implicit_tension.h"

namespace foamsim {

/// J as Eigen's iterative solvers want it.
class ImplicitJacobian;

}  // namespace foamsim

namespace Eigen::internal {

template <>
struct traits<foamsim::ImplicitJacobian> : traits<SparseMatrix<double>> {};

}  // namespace Eigen::internal

namespace foamsim {

class ImplicitJacobian : public Eigen::EigenBase<ImplicitJacobian> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = 0 };

  explicit ImplicitJacobian(const ImplicitTension& equation) : equation_(equation) {}
  Eigen::Index rows() const { return equation_.size(); }
  Eigen::Index cols() const { return equation_.size(); }
  template <class Vector>
  Eigen::Product<ImplicitJacobian, Vector, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Vector>& vector) const {
    return {*this, vector.derived()};
  }
  const ImplicitTension& equation() const { return equation_; }

 private:
  const ImplicitTension& equation_;
};

}  // namespace foamsim

namespace Eigen::internal {

template <class Vector>
struct generic_product_impl<foamsim::ImplicitJacobian, Vector, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<foamsim::ImplicitJacobian, Vector,
                                generic_product_impl<foamsim::ImplicitJacobian, Vector>> {
  using Scalar = double;
  template <class Result>
  // NOLINTNEXTLINE(readability-identifier-naming): what Eigen calls
  static void scaleAndAddTo(Result& result, const foamsim::ImplicitJacobian& jacobian, const Vector& vector,
                            const Scalar& factor) {
    result += factor * jacobian.equation().apply(vector);
  }
};

}  // namespace Eigen::internal

namespace foamsim {

using lostopos::Vec3;

namespace {

// Of a linear system against its right side, and rounds of GMRES at most; the next Newton step sees to the rest.
constexpr double linear_tolerance = 1e-10;
constexpr int most_linear_rounds = 300;
constexpr int rounds_before_restart = 60;

// Where Newton's method goes round in circles, it ends with the least residual that it has seen.
constexpr long most_rounds_without_gain = 5;

void require_finite(const Eigen::VectorXd& change, const char* integrator) {
  if (!change.allFinite())
    throw base::Error(std::string("integrator=") + integrator +
                      " finds no circulation for this step; a shorter dt has one");
}

Eigen::VectorXd newton_step(const ImplicitTension& equation, const Eigen::VectorXd& residual) {
  const ImplicitJacobian jacobian(equation);
  Eigen::GMRES<ImplicitJacobian, Eigen::IdentityPreconditioner> solver;
  solver.setTolerance(linear_tolerance);
  solver.setMaxIterations(most_linear_rounds);
  solver.set_restart(rounds_before_restart);
  solver.compute(jacobian);
  return solver.solve(-residual);
}

}  // namespace

long Implicit::kick(const CirculationKick& kick) {
  ImplicitTension equation(kick);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(equation.size()), best = change;
  double least = std::numeric_limits<double>::infinity();
  long round = 0, since_best = 0;
  for (double correction = 1; correction >= implicit_tolerance && round < most_implicit_rounds; ++round) {
    const Eigen::VectorXd residual = equation.residual(change);
    require_finite(residual, "implicit");
    if (residual.norm() < least) {
      least = residual.norm();
      best = change;
      since_best = 0;
    } else if (++since_best == most_rounds_without_gain) {
      equation.add(best);
      return most_implicit_rounds;
    }
    equation.linearise();
    const Eigen::VectorXd step = newton_step(equation, residual);
    require_finite(step, "implicit");
    change += step;
    correction = step.norm();
  }
  equation.add(change);
  return round;
}

void Implicit::advance(double dt, std::span<const Vec3> x, std::span<const Vec3> u, const StageMotion& motion,
                       std::vector<Vec3>& predicted) {
  Euler().advance(dt, x, u, motion, predicted);
}

long PositionBased::kick(const CirculationKick& kick) {
  ImplicitTension equation(kick);
  if (equation.size() > most_pbd_unknowns)
    throw base::InputError("integrator=pbd is for surfaces with at most " + std::to_string(most_pbd_unknowns) +
                           " circulations, and this one has " + std::to_string(equation.size()) +
                           "; integrator=implicit solves the same equation for any");
  Eigen::VectorXd change = Eigen::VectorXd::Zero(equation.size());
  long round = 0;
  for (double correction = 1; correction >= implicit_tolerance && round < most_implicit_rounds; ++round) {
    const Eigen::VectorXd residual = equation.residual(change);
    require_finite(residual, "pbd");
    equation.linearise();
    const Eigen::VectorXd step =
        -equation.apply_transposed(Eigen::VectorXd(residual.array() / equation.squared_rows().array()));
    change += step;
    correction = step.norm();
  }
  require_finite(change, "pbd");
  equation.add(change);
  return round;
}

}  // namespace foamsim
