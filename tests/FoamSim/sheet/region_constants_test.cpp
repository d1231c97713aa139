#include "FoamSim/sheet/region_constants.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

std::vector<double> reduced(SurfaceMesh& mesh, const CirculationField& circulation) {
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  return circulation_without_region_constants(mesh, sheet, mesh.positions());
}

TEST(RegionConstants, OfOneBubbleIsTheAreaWeightedMean) {
  SurfaceMesh mesh = cube(2);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices()) circulation.set(v, {Region(1), air}, 5 + mesh.position(v).x());
  // The cube is its own mirror image: the mean of x is 0.
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  const auto without = circulation_without_region_constants(mesh, sheet, mesh.positions());
  for (std::size_t i = 0; i < sheet.size(); ++i) EXPECT_NEAR(without[i], sheet[i].mean_circulation() - 5, 1e-13);
}

TEST(RegionConstants, AreTakenOutOfAFoamWhole) {
  SurfaceMesh mesh = double_bubble(8);
  lostopos::test::add_corner_tetrahedron(mesh, 1, {10, 0, 0}, Region(9), air);
  lostopos::test::add_corner_tetrahedron(mesh, 0.2, {-0.5, 0, 0}, Region(4), Region(1));
  CirculationField circulation(mesh);
  const std::array<double, 10> constant{3, -1, 4, 0, 15, 0, 0, 0, 0, -926};
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v))
      held.value = constant[held.pair.low.index()] - constant[held.pair.high.index()];
  for (double value : reduced(mesh, circulation)) EXPECT_NEAR(value, 0, 1e-11);
}

TEST(RegionConstants, LeaveWhatIsNoConstantOfRegions) {
  // Round a border, constants of the three films that do not come from regions: (1, 1, 1) adds up to 3.
  auto junction = lostopos::test::triple_junction({120, 120, 120});
  CirculationField circulation(junction.mesh);
  for (Vertex v : junction.mesh.vertices())
    for (std::size_t r = 0; r < 3; ++r)
      if (const Labels turn{Region(r), Region((r + 1) % 3)};
          std::ranges::count(circulation.at(v), RegionPair(turn), &PairCirculation::pair) > 0)
        circulation.set(v, turn, 1);
  for (double value : reduced(junction.mesh, circulation)) EXPECT_NEAR(value, 1, 1e-14);
}

TEST(RegionConstants, GroupsThatDoNotTouchAreTreatedEachForItself) {
  SurfaceMesh mesh;
  lostopos::test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), Region(2));
  lostopos::test::add_corner_tetrahedron(mesh, 1, {5, 0, 0}, Region(3), Region(4));
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = held.pair.low == Region(1) ? 8 : -3;
  for (double value : reduced(mesh, circulation)) EXPECT_NEAR(value, 0, 1e-14);
}

TEST(RegionConstants, OfThousandsOfRegions) {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i < 2000; ++i)
    lostopos::test::add_corner_tetrahedron(mesh, 1, {2.0 * static_cast<double>(i), 0, 0}, Region(i + 1), air);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = held.pair.high.index();
  for (double value : reduced(mesh, circulation)) EXPECT_NEAR(value, 0, 1e-9);
}

}  // namespace
}  // namespace foamsim
