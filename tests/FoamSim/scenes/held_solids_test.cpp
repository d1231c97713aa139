// What is a solid: where a file of the reference program says so, and nowhere else.
#include <gtest/gtest.h>

#include "FoamSim/constraints/fixed_frame.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/io/rec.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/film_meshes.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

using lostopos::Hold;
using lostopos::Triangle;
using lostopos::Vertex;

std::size_t solids(const Simulation& simulation) {
  std::size_t count = 0;
  for (Triangle t : simulation.mesh().triangles()) count += simulation.solid()[t.index()] != 0 ? 1U : 0U;
  return count;
}

// Two triangles at a corner of a cube frame have all three corners on the wire.
TEST(Solids, AFrameHasNone) {
  auto cube = lostopos::test::cube_frame(2);
  SimulationParts parts = test::parts();
  parts.constraints.push_back(std::make_unique<FixedFrame>(cube.frame));
  const Simulation simulation(std::move(cube.mesh), {}, std::move(parts));
  for (Vertex v : cube.frame) EXPECT_EQ(simulation.held()[v.index()], Hold::all);
  EXPECT_EQ(solids(simulation), 0U);
}

TEST(Solids, AreTheTrianglesOfAFileWithThreeHeldCorners) {
  const ::test::ScratchFolder folder;
  const auto mesh = lostopos::test::analytic_double_bubble(1, 8);
  lostopos::SurfaceData data = from_mesh(mesh);
  for (Vertex v : mesh.vertices(Triangle(7))) data.held.push_back({v.index(), mesh.position(v)});
  const auto file = folder.path() / "held.rec";
  write_rec(file, data);
  const Simulation simulation = make_simulation(load_scene(file.string()));
  EXPECT_EQ(solids(simulation), 1U);
  EXPECT_NE(simulation.solid()[7], 0);
  for (Vertex v : mesh.vertices(Triangle(7))) EXPECT_EQ(simulation.held()[v.index()], Hold::all);
}

}  // namespace
}  // namespace foamsim
