#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::stability {

using lostopos::Vec3;

namespace {

constexpr double moved_tolerance = 1e-6;
// 1,000 radii, in a direction that is none of the mesh's.
const Vec3 offset = 1000 * Vec3(2, -6, 3) / 7;

CaseRun moved_run(const CaseSetup& setup, std::string label, const Vec3& by) {
  auto start = [setup, by] {
    lostopos::SurfaceMesh mesh = double_bubble(16);
    const double resolution = lostopos::mean_edge_length(mesh);
    // Without it, edges that are alike by symmetry would be told apart by rounding alone, which is another there.
    add_noise(mesh, 1e-3 * resolution, 1);
    transform(mesh, 1, by);
    return simulated(setup, std::move(mesh), {.resolution = resolution});
  };
  return {std::move(label), start, scaled_steps(200, setup)};
}

std::vector<CaseRun> runs_of_moved(const CaseSetup& setup) {
  return {moved_run(setup, "at the origin", Vec3::Zero()), moved_run(setup, "moved", offset)};
}

Verdict judge_moved(std::span<const Trajectory> t) {
  const double difference = largest_difference(t[0], t[1], 1, offset);
  return Judgement()
      .require_sound(t[0])
      .require_sound(t[1])
      .require(difference <= moved_tolerance, "the moved motion is not the same to 1e-6")
      .set_figure("largest relative difference", difference)
      .verdict();
}

}  // namespace

StabilityCase moved_origin() {
  return {.name = "moved",
          .summary = "double bubble (N = 16, noise of 1e-3 h) moved by 1,000 radii, 200 steps",
          .criterion = "the same motion to 1e-6: measures of every step and all vertices at the end",
          .typical_triangles = 1000,
          .runs = runs_of_moved,
          .judge = judge_moved};
}

}  // namespace foamsim::stability
