#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/clusters.h"

namespace foamsim::stability {
namespace {

constexpr long edges_along_border = 6;
constexpr double displacement = 0.7;  // of an edge

std::unique_ptr<MeasuredMotion> start_of_quad_point(const CaseSetup& setup) {
  TetrahedralCluster cluster = tetrahedral_cluster(edges_along_border);
  cluster.mesh.set_position(cluster.middle,
                            displacement / static_cast<double>(edges_along_border) * cluster.corners[0]);
  return simulated(setup, std::move(cluster.mesh), {.dt = 0.005});
}

}  // namespace

StabilityCase displaced_quad_point() {
  return {.name = "quad-point",
          .summary =
              "four bubbles whose Plateau vertex is displaced by 70% of its edge along a border, 1,000 steps of 0.005",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 700,
          .runs = [](const CaseSetup& setup) { return one_run(setup, start_of_quad_point, 1000); },
          .judge = within_physics};
}

}  // namespace foamsim::stability
