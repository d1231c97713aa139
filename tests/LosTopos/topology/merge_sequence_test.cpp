// Random sequences of operations with merges, separations and vanishing regions among them: the mesh stays sound, and
// is the same to the bit when it says no.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/LosTopos/topology/random_operations.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

rc::Gen<std::vector<test::RandomOperation>> operations() {
  const auto kind = rc::gen::map(rc::gen::inRange(0, test::operation_kinds),
                                 [](int number) { return static_cast<test::OperationKind>(number); });
  const auto operation =
      rc::gen::construct<test::RandomOperation>(kind, rc::gen::arbitrary<std::uint32_t>(), rc::gen::arbitrary<bool>());
  return rc::gen::resize(60, rc::gen::container<std::vector<test::RandomOperation>>(operation));
}

void run_sequence(SurfaceMesh mesh, std::span<const Vertex> held_vertices, bool closed) {
  const test::Cargo cargo(mesh);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  for (Vertex v : held_vertices) held[v] = Hold::all;
  const std::vector<Vec3> start(mesh.positions().begin(), mesh.positions().end());
  const double distance = 0.4 * mean_edge_length(mesh);
  RemeshContext context(mesh, held, test::wide_bounds());
  for (const test::RandomOperation& operation : *operations()) {
    if (mesh.triangle_count() == 0) return;
    const auto before = mesh.state();
    if (perform(context, distance, operation)) {
      RC_ASSERT(test::same_bits(before, mesh.state()));
      continue;
    }
    const AuditReport report = audit(mesh, {.closed_regions = closed});
    RC_ASSERT(report.text() == "clean");
    RC_ASSERT(mesh.triangle_count() == 0 || cargo.holds());
  }
  for (Vertex v : held_vertices) {
    RC_ASSERT(mesh.alive(v));
    RC_ASSERT(mesh.position(v) == start[v.index()]);
  }
}

RC_GTEST_PROP(MergeSequence, OnDoubleBubbles, ()) {
  run_sequence(test::analytic_double_bubble(1, *rc::gen::inRange(6, 14)), {}, true);
}

RC_GTEST_PROP(MergeSequence, OnTwoSpheresThatAreClose, ()) {
  const Region right(*rc::gen::arbitrary<bool>() ? 1u : 2u);
  run_sequence(test::two_spheres(1, 0.1, Region(1), right), {}, true);
}

RC_GTEST_PROP(MergeSequence, OnACubeFrameOfFilms, ()) {
  auto cube = test::cube_frame(*rc::gen::inRange(1, 5));
  run_sequence(std::move(cube.mesh), cube.frame, false);
}

RC_GTEST_PROP(MergeSequence, OnAFoamOfTwentyBubbles, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
  run_sequence(voronoi_foam({.cells = 20, .seed = seed}), {}, true);
}

}  // namespace
}  // namespace lostopos
