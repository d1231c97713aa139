#include "LosTopos/remeshing/remesh_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "LosTopos/mesh/measures.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

// A double bubble drawn out, so that every operation has work.
SurfaceMesh drawn_out_bubbles() {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 16);
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    mesh.set_position(v, Vec3(x[0] / std::sqrt(1.6), x[1] * 1.6, x[2] / std::sqrt(1.6)));
  }
  return mesh;
}

struct Passes {
  std::size_t first_moved = 0, later_moved = 0, refused = 0;  // by smoothing
};

// `forgetful`: every pass looks at all vertices, also those that the one before has settled.
Passes four_passes(SurfaceMesh& mesh, bool forgetful) {
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshOptions options;
  options.target_edge = mean_edge_length(mesh);
  options.smooth_below_angle = 60;
  RemeshContext context(mesh, held, options);
  RemeshStatistics statistics;
  RemeshPass pass(context, statistics);
  Passes result;
  pass.split_long_edges();
  for (int round = 0; round < 4; ++round) {
    if (forgetful) context.settled = {};
    const std::size_t before = statistics[Operation::smoothing].done;
    pass.collapse_short_edges();
    pass.flip_edges();
    pass.smooth();
    (round == 0 ? result.first_moved : result.later_moved) += statistics[Operation::smoothing].done - before;
  }
  result.refused = statistics[Operation::smoothing].refused_in_all();
  return result;
}

TEST(RemeshPass, LeavesSettledVerticesAloneToNoOtherResult) {
  SurfaceMesh mesh = drawn_out_bubbles(), looked_at_again = mesh.clone();
  const Passes passes = four_passes(mesh, false), again = four_passes(looked_at_again, true);
  EXPECT_TRUE(test::same_bits(mesh.state(), looked_at_again.state()));
  EXPECT_EQ(passes.later_moved, again.later_moved);
  EXPECT_EQ(passes.refused, again.refused);
  // Neither all settle at once nor none.
  EXPECT_GT(passes.first_moved, 100U);
  EXPECT_GT(passes.later_moved, 100U);
  EXPECT_GT(passes.refused, 100U);
}

}  // namespace
}  // namespace lostopos
