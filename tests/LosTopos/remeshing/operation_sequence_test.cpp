// Random sequences of operations, asked of elements that may have no need of them: the mesh stays sound, and is the
// same to the bit when it says no.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

struct Step {
  int kind;
  std::uint32_t element;
};

rc::Gen<std::vector<Step>> steps() {
  const auto step = rc::gen::construct<Step>(rc::gen::inRange(0, 4), rc::gen::arbitrary<std::uint32_t>());
  return rc::gen::resize(60, rc::gen::container<std::vector<Step>>(step));
}

template <class Range>
auto element(const Range& range, std::size_t count, std::uint32_t choice) {
  auto it = range.begin();
  std::advance(it, choice % count);
  return *it;
}

std::optional<Refusal> perform(RemeshContext& context, const Step& step) {
  const SurfaceMesh& mesh = context.mesh;
  if (step.kind == 3)
    return NullSpaceSmoothing(context).attempt(element(mesh.vertices(), mesh.vertex_count(), step.element));
  const Edge e = element(mesh.edges(), mesh.edge_count(), step.element);
  if (step.kind == 0) return EdgeSplit(context).attempt(e);
  if (step.kind == 1) return EdgeCollapse(context).attempt(e);
  return EdgeFlip(context).attempt(e);
}

// Bounds so wide that hardly anything but topology and intersections can refuse.
void run_sequence(SurfaceMesh mesh, std::span<const Vertex> held_vertices, bool closed, bool smooth_positions) {
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  for (Vertex v : held_vertices) held[v] = Hold::all;
  RemeshOptions options = test::wide_bounds();
  options.use_butterfly = smooth_positions;
  const std::vector<Vec3> start(mesh.positions().begin(), mesh.positions().end());
  const long euler = euler_characteristic(mesh);
  const auto regions_at_start = regions(mesh);
  RemeshContext context(mesh, held, options);
  for (const Step& step : *steps()) {
    const auto before = mesh.state();
    if (perform(context, step)) {
      RC_ASSERT(test::same_bits(before, mesh.state()));
      continue;
    }
    const AuditReport report = audit(mesh, {.closed_regions = closed});
    RC_ASSERT(report.text() == "clean");
    RC_ASSERT(euler_characteristic(mesh) == euler);
    RC_ASSERT(regions(mesh) == regions_at_start);
  }
  for (Vertex v : held_vertices) {
    RC_ASSERT(mesh.alive(v));
    RC_ASSERT(mesh.position(v) == start[v.index()]);
  }
}

RC_GTEST_PROP(OperationSequence, OnDoubleBubbles, ()) {
  run_sequence(test::analytic_double_bubble(1, *rc::gen::inRange(6, 14)), {}, true, *rc::gen::arbitrary<bool>());
}

RC_GTEST_PROP(OperationSequence, OnACubeFrameOfFilms, ()) {
  auto cube = test::cube_frame(*rc::gen::inRange(1, 5));
  run_sequence(std::move(cube.mesh), cube.frame, false, *rc::gen::arbitrary<bool>());
}

// Unlike the others it has points at which four borders and more meet.
RC_GTEST_PROP(OperationSequence, OnAFoamOfTwentyBubbles, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
  run_sequence(voronoi_foam({.cells = 20, .seed = seed}), {}, true, *rc::gen::arbitrary<bool>());
}

}  // namespace
}  // namespace lostopos
