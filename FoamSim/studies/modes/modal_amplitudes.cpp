#include "FoamSim/studies/modes/modal_amplitudes.h"

#include <Eigen/Core>
#include <cmath>

#include "FoamSim/linear/dense_solve.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

std::array<double, fitted_modes> modal_amplitudes(const lostopos::SurfaceMesh& mesh) {
  constexpr int n = fitted_modes;
  Eigen::Matrix<double, n, n> matrix = Eigen::Matrix<double, n, n>::Zero();
  Eigen::Matrix<double, n, 1> right = Eigen::Matrix<double, n, 1>::Zero();
  for (Vertex v : mesh.vertices()) {
    double weight = 0;
    for (Triangle t : mesh.triangles(v)) weight += lostopos::area(mesh, t) / 3;
    const Vec3& x = mesh.position(v);
    const double r = x.norm();
    Eigen::Matrix<double, n, 1> basis;
    for (unsigned k = 0; k < fitted_modes; ++k) basis[k] = std::legendre(k, x.x() / r);
    matrix += weight * basis * basis.transpose();
    right += weight * r * basis;
  }
  const Eigen::Matrix<double, n, 1> solution = solve_symmetric(matrix, right);
  std::array<double, fitted_modes> amplitudes;
  for (int k = 0; k < n; ++k) amplitudes[k] = solution[k];
  return amplitudes;
}

}  // namespace foamsim
