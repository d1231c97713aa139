#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim::stability {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr double speed = 0.5;           // of each bubble, L/T
const Vec3 right_centre(1.2, 0.35, 0);  // the left one lies opposite; both have radius 1

SurfaceMesh two_spheres() {
  const SurfaceMesh sphere = lostopos::icosphere(2);
  SurfaceMesh mesh;
  for (int side : {-1, 1}) {
    std::vector<Vertex> copy;
    for (Vertex v : sphere.vertices()) copy.push_back(mesh.add_vertex(sphere.position(v) + side * right_centre));
    for (lostopos::Triangle t : sphere.triangles()) {
      const auto& [a, b, c] = sphere.vertices(t);
      mesh.add_triangle(copy[a.index()], copy[b.index()], copy[c.index()],
                        {lostopos::Region(side < 0 ? 1 : 2), lostopos::air});
    }
  }
  return mesh;
}

// A sphere that moves with velocity U through still air: the potential is U·x inside and −R³ U·x / (2 r³) outside, so
// that its jump across the film is 2Γ = −(3/2) U·x.
void move_towards_each_other(const SurfaceMesh& mesh, CirculationField& circulation) {
  for (Vertex v : mesh.vertices()) {
    const int side = mesh.position(v).x() < 0 ? -1 : 1;
    const Vec3 velocity(-side * speed, 0, 0);
    const auto inside = lostopos::Region(side < 0 ? 1 : 2);
    circulation.set(v, {inside, lostopos::air}, -0.75 * velocity.dot(mesh.position(v) - side * right_centre));
  }
}

std::vector<CaseRun> runs_of_meeting(const CaseSetup& setup) {
  auto start = [setup] { return simulated(setup, two_spheres(), {.circulation = move_towards_each_other}); };
  // All the steps in any case: before they meet there is nothing to judge.
  return {{"", start, 400}};
}

Verdict judge_meeting(std::span<const Trajectory> t) {
  const long joined = t[0].samples.empty() ? 0 : t[0].samples.back().topology_totals.snaps;
  return Judgement()
      .require_physics(t[0])
      .require(joined > 0, "the bubbles have not joined: no snap")
      .set_figure("snaps", static_cast<double>(joined))
      .verdict();
}

}  // namespace

StabilityCase meeting_off_axis() {
  return {.name = "meeting",
          .summary = "two bubbles of radius 1 that meet 0.7 off their axis at a relative speed of 1, 400 steps",
          .criterion = "they join by snapping; energy, volumes and impulse within the limits of physics",
          .remeshing = Remeshing::on_only,
          .typical_triangles = 700,
          .runs = runs_of_meeting,
          .judge = judge_meeting};
}

}  // namespace foamsim::stability
