#include "FoamSim/dynamics/relaxation.h"

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <limits>

#include "Base/timing/stopwatch.h"
#include "FoamSim/sheet/bubble_volumes.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// Numbers of the vertices that move, by slot; the others have `none`.
constexpr int none = -1;
std::vector<int> numbers_of_free(const EffectStep& step, int& count) {
  std::vector<int> number(step.mesh.vertex_slots(), none);
  count = 0;
  for (Vertex v : step.mesh.vertices())
    if (!step.is_held(v)) number[v.index()] = count++;
  return number;
}

// Of the angles at the three corners. Negative ones count as 0, which damps more and keeps the matrix positive; those
// of needles are bounded.
std::array<double, 3> cotangents(const std::array<Vec3, 3>& x, double doubled_area) {
  constexpr double largest = 10;
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double cosine = (x[(k + 1) % 3] - x[k]).dot(x[(k + 2) % 3] - x[k]);
    result[k] = std::clamp(cosine / doubled_area, 0.0, largest);
  }
  return result;
}

// A/dt + T L of the free vertices.
Matrix matrix_of(const StepScope& scope, const std::vector<int>& number, int count, double tension) {
  const SurfaceMesh& mesh = scope.mesh();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.triangle_count() * 12);
  for (Triangle t : mesh.triangles()) {
    const auto corners = mesh.vertices(t);
    const std::array x{mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[2])};
    const double doubled_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
    if (!(doubled_area > 0)) continue;
    const bool film = scope.solid().empty() || scope.solid()[t.index()] == 0;
    const std::array cotangent = cotangents(x, doubled_area);
    for (std::size_t k = 0; k < 3; ++k) {
      const int own = number[corners[k].index()];
      if (own != none) entries.emplace_back(own, own, doubled_area / 6 / scope.step().dt);
      const double weight = film ? tension * cotangent[k] / 2 : 0;
      const int b = number[corners[(k + 1) % 3].index()], c = number[corners[(k + 2) % 3].index()];
      if (b != none) entries.emplace_back(b, b, weight);
      if (c != none) entries.emplace_back(c, c, weight);
      if (b == none || c == none) continue;
      entries.emplace_back(b, c, -weight);
      entries.emplace_back(c, b, -weight);
    }
  }
  Matrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Takes from a gradient of energy what pressures in the closed bubbles balance: the least is left over, with areas as
// weights.
void balance_by_pressures(const StepScope& scope, std::span<Vec3> gradient) {
  BubbleVolumes bubbles(scope.mesh(), closed_bubbles(scope.mesh()));
  if (bubbles.rows() == 0) return;
  if (!bubbles.update(scope.positions(), [&](Vertex v) { return !scope.step().is_held(v); })) return;
  const Eigen::VectorXd pressures = bubbles.solve(-bubbles.product(gradient));
  if (pressures.size() > 0) bubbles.add(pressures, false, gradient);
}

}  // namespace

double Relaxation::attach(SurfaceMesh& /*mesh*/, const DynamicsStart& start) {
  resolution_ = start.resolution;
  return start.delta > 0 ? start.delta : start.resolution;
}

double Relaxation::suitable_dt(const EffectStep& /*step*/, double tension) {
  if (!(tension > 0)) return std::numeric_limits<double>::infinity();
  return 2 * resolution_ * resolution_ / tension;
}

void Relaxation::advance(StepScope& scope, std::vector<Vec3>& predicted) {
  constexpr double negligible = 1e-6;
  const auto positions = scope.positions();
  predicted.assign(positions.begin(), positions.end());
  scope.report().potential_energy = scope.potential_energy();
  const base::TimedScope timed(scope.report().times, "relaxation");
  std::vector<Vec3> gradient(positions.size(), Vec3::Zero());
  scope.add_force(0, positions, gradient);
  balance_by_pressures(scope, gradient);
  int count = 0;
  const std::vector<int> number = numbers_of_free(scope.step(), count);
  Columns force(count, 3);
  for (Vertex v : scope.mesh().vertices())
    if (number[v.index()] != none) force.row(number[v.index()]) = -gradient[v.index()].transpose();
  const Matrix matrix = matrix_of(scope, number, count, scope.tension());
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(negligible);
  solver.setMaxIterations(most_iterations);
  solver.compute(matrix);
  const Columns displacement = solver.solve(force);
  const double longest = longest_motion * resolution_;
  for (Vertex v : scope.mesh().vertices()) {
    if (number[v.index()] == none) continue;
    const Vec3 d = displacement.row(number[v.index()]);
    predicted[v.index()] += d.norm() > longest ? Vec3(longest / d.norm() * d) : d;
  }
  std::vector<Vec3> velocity(positions.size(), Vec3::Zero());
  scope.add_velocity(0, positions, velocity);
  for (std::size_t v = 0; v < velocity.size(); ++v) predicted[v] += scope.step().dt * velocity[v];
  scope.correct_positions(scope.step().dt, predicted);
}

}  // namespace foamsim
