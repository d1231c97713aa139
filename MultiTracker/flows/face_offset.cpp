#include "MultiTracker/flows/face_offset.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "LosTopos/mesh/for_each_living.h"
#include "LosTopos/mesh/measures.h"

namespace multitracker {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr double least_eigenvalue = 0.003;  // over the largest

// The least-norm solution of A d = b in the space of A's eigenvectors whose eigenvalues are not small.
Vec3 solve_in_primary_space(const Eigen::Matrix3d& a, const Vec3& b) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes;
  modes.computeDirect(a);
  Vec3 d = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (!(modes.eigenvalues()[i] > least_eigenvalue * modes.eigenvalues()[2])) continue;
    const Vec3 mode = modes.eigenvectors().col(i);
    d += mode.dot(b) / modes.eigenvalues()[i] * mode;
  }
  return d;
}

}  // namespace

Vec3 FaceOffsetFlow::displacement(const FlowStep& step, Vertex v) const {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero(), arm = Vec3::Zero();
  double fastest = 0;
  for (lostopos::Triangle t : step.mesh.triangles(v)) {
    const Vec3 area_vector = lostopos::area_vector(step.mesh, t);
    const double area = area_vector.norm();
    if (!(area > 0)) continue;
    const Vec3 normal = area_vector / area;
    const double offset = speeds_.along_normal(step.mesh.labels(t)) * step.dt;
    a += area * normal * normal.transpose();
    b += area * offset * normal;
    fastest = std::max(fastest, std::abs(offset));
    if (offset != 0) arm += area * (lostopos::barycentre(step.mesh, t) - step.mesh.position(v));
  }
  const Vec3 d = solve_in_primary_space(a, b);
  const double length = d.norm();
  const bool runs_apart = arm.dot(d) < 0;  // the moving films lie behind
  return runs_apart && length > fastest ? Vec3(fastest / length * d) : d;
}

std::vector<Vec3> FaceOffsetFlow::predicted(const FlowStep& step) const {
  std::vector<Vec3> ends(step.mesh.positions().begin(), step.mesh.positions().end());
  lostopos::for_each_vertex(step.mesh, [&](Vertex v) {
    ends[v.index()] += lostopos::free_part(step.held[v.index()], displacement(step, v));
  });
  return ends;
}

}  // namespace multitracker
