#include "FoamSim/studies/accuracy/equilibrium_errors.h"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "Base/error.h"
#include "FoamSim/linear/dense_solve.h"
#include "FoamSim/metrics/film_angles.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"
#include "FoamSim/sheet/pressure/curvature.h"
#include "FoamSim/sheet/pressure/vertex_area/averaged.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr std::array bubbles{Region(1), Region(2)};

std::array<double, 2> volumes_of(const SurfaceMesh& mesh) {
  const auto volumes = lostopos::region_volumes(mesh);
  if (volumes.size() != 3 || volumes[1].region != bubbles[0] || volumes[2].region != bubbles[1] ||
      lostopos::junction_edge_count(mesh) == 0)
    throw base::InputError("the surface is not a double bubble: its bubbles have to be regions 1 and 2, joined");
  return {volumes[1].volume, volumes[2].volume};
}

// A third of the area of the triangles between r and the air at v; 0 off that film and at the border.
double outer_film_area(const SurfaceMesh& mesh, Vertex v, Region r) {
  if (mesh.is_junction(v)) return 0;
  double sum = 0;
  for (Triangle t : mesh.triangles(v)) {
    if (!mesh.labels(t).has(r) || !mesh.labels(t).has(air)) return 0;
    sum += lostopos::area(mesh, t) / 3;
  }
  return sum;
}

// |x|² = 2 c·x + (R² − |c|²) is linear in the centre c and the constant.
double fitted_radius(const SurfaceMesh& mesh, Region r) {
  const Vec3 origin = lostopos::surface_centroid(mesh);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (Vertex v : mesh.vertices()) {
    const double weight = outer_film_area(mesh, v, r);
    const Vec3 x = mesh.position(v) - origin;
    const Eigen::Vector4d row(2 * x.x(), 2 * x.y(), 2 * x.z(), 1);
    matrix += weight * row * row.transpose();
    right += weight * x.squaredNorm() * row;
  }
  const Eigen::Vector4d solution = solve_symmetric(matrix, right);
  return std::sqrt(solution[3] + solution.head<3>().squaredNorm());
}

double rim_radius(const SurfaceMesh& mesh) {
  Vec3 centre = Vec3::Zero();
  double count = 0, sum = 0;
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) {
      centre += mesh.position(v);
      ++count;
    }
  centre /= count;
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) sum += (mesh.position(v) - centre).norm();
  return sum / count;
}

double wall_area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Triangle t : mesh.triangles())
    if (!mesh.labels(t).has(air)) sum += lostopos::area(mesh, t);
  return sum;
}

double mean_curvature(const SurfaceMesh& mesh, const SurfaceGeometry& geometry, const CurvatureField& curvature,
                      Region r) {
  double sum = 0, weights = 0;
  for (Vertex v : mesh.vertices()) {
    const double weight = outer_film_area(mesh, v, r);
    if (weight == 0) continue;
    sum += weight * curvature.get(geometry, v, r);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

EquilibriumErrors equilibrium_errors(const SurfaceMesh& mesh) {
  const auto [volume1, volume2] = volumes_of(mesh);
  const DoubleBubbleEquilibrium exact = double_bubble_equilibrium(volume1, volume2);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  CurvatureField curvature;
  // Away from the border all strategies take the same area.
  curvature.update(mesh, geometry, EdgeAngleCurvature(std::make_unique<AveragedArea>()));
  EquilibriumErrors errors;
  errors.area = geometry.total_area() / exact.total_area() - 1;
  errors.rim = rim_radius(mesh) / exact.rim_radius - 1;
  errors.wall = wall_area(mesh) / exact.wall.area - 1;
  for (std::size_t b = 0; b < bubbles.size(); ++b) {
    errors.radius += (fitted_radius(mesh, bubbles[b]) / exact.outer[b].radius - 1) / 2;
    errors.pressure += (mean_curvature(mesh, geometry, curvature, bubbles[b]) / exact.pressure(b) - 1) / 2;
  }
  const JunctionAngles angles = junction_angles(mesh);
  errors.angle_rms_deg = angles.rms_deviation_deg;
  errors.angle_rms_film_deg = film_angles(mesh).rms_deviation_deg;
  errors.angle_outer_mean_deg = angles.outer_mean_deg;
  return errors;
}

}  // namespace foamsim
