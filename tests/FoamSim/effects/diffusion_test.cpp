#include "FoamSim/effects/diffusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

constexpr Labels kFilm{Region(1), air};
constexpr std::size_t kColumns = 8, kRows = 6;

// A torus of squares with a diagonal each: every vertex has the same six neighbours, (±1, 0), (0, ±1), ±(1, 1).
SurfaceMesh torus() {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i < kColumns; ++i)
    for (std::size_t j = 0; j < kRows; ++j) {
      const double a = 2 * pi * static_cast<double>(i) / kColumns, b = 2 * pi * static_cast<double>(j) / kRows;
      mesh.add_vertex({(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)});
    }
  auto vertex = [](std::size_t i, std::size_t j) { return Vertex((i % kColumns) * kRows + j % kRows); };
  for (std::size_t i = 0; i < kColumns; ++i)
    for (std::size_t j = 0; j < kRows; ++j) {
      mesh.add_triangle(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), kFilm);
      mesh.add_triangle(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1), kFilm);
    }
  return mesh;
}

double wave(Vertex v, int m, int n) {
  const auto column = static_cast<int>(v.index() / kRows), row = static_cast<int>(v.index() % kRows);
  return std::cos(2 * pi * (m * static_cast<double>(column) / kColumns + n * static_cast<double>(row) / kRows));
}

struct AgedFilm {
  explicit AgedFilm(SurfaceMesh m) : mesh(std::move(m)), circulation(mesh) { geometry.update(mesh); }
  void diffuse(Diffusion& diffusion, double dt) { diffusion.update_circulation({mesh, geometry, 0, dt}, circulation); }

  SurfaceMesh mesh;
  SurfaceGeometry geometry;
  CirculationField circulation;
};

TEST(Diffusion, DampsEveryWaveByItsOwnFactor) {
  for (const auto& [m, n] : {std::pair(1, 0), std::pair(0, 1), std::pair(2, 1), std::pair(3, 2), std::pair(4, 3)}) {
    AgedFilm stage(torus());
    for (Vertex v : stage.mesh.vertices()) stage.circulation.set(v, kFilm, wave(v, m, n));
    Diffusion diffusion(10);
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) stage.diffuse(diffusion, 0.02);
    const double a = 2 * pi * m / kColumns, b = 2 * pi * n / kRows;
    const double neighbours = (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;
    const double factor = std::pow(1 - 10 * 0.02 * (1 - neighbours), steps);
    for (Vertex v : stage.mesh.vertices())
      EXPECT_NEAR(stage.circulation.get(v, kFilm), factor * wave(v, m, n), 1e-14) << m << "," << n;
  }
}

TEST(Diffusion, TakesTheMeanOfEachPairAway) {
  AgedFilm stage(torus());
  for (Vertex v : stage.mesh.vertices()) stage.circulation.set(v, kFilm, 1000 + wave(v, 1, 1));
  Diffusion diffusion(10);
  stage.diffuse(diffusion, 0.01);
  double sum = 0;
  for (Vertex v : stage.mesh.vertices()) sum += stage.circulation.get(v, kFilm);
  EXPECT_NEAR(sum, 0, 1e-10);
  EXPECT_NEAR(stage.circulation.get(Vertex(0), kFilm),
              1 - 0.1 * (1 - (std::cos(pi / 4) + std::cos(pi / 3) + std::cos(pi / 4 + pi / 3)) / 3), 1e-12);
}

TEST(Diffusion, GoesNoFurtherThanTheNeighboursMean) {
  AgedFilm stage(torus());
  for (Vertex v : stage.mesh.vertices()) stage.circulation.set(v, kFilm, wave(v, 2, 3));
  const double neighbours = (std::cos(pi / 2) + std::cos(pi) + std::cos(3 * pi / 2)) / 3;
  Diffusion diffusion(10);
  stage.diffuse(diffusion, 5);
  for (Vertex v : stage.mesh.vertices())
    EXPECT_NEAR(stage.circulation.get(v, kFilm), neighbours * wave(v, 2, 3), 1e-14);
}

TEST(Diffusion, OfRateZeroLeavesEveryBitAlone) {
  AgedFilm stage(torus());
  for (Vertex v : stage.mesh.vertices()) stage.circulation.set(v, kFilm, 7 + v.index() / 3.0);
  Diffusion diffusion(0);
  stage.diffuse(diffusion, 0.01);
  for (Vertex v : stage.mesh.vertices()) EXPECT_EQ(stage.circulation.get(v, kFilm), 7 + v.index() / 3.0);
}

TEST(Diffusion, DoesNotMixThePairsThatMeetAtABorder) {
  for (const RegionPair source : {RegionPair(kFilm), RegionPair(air, Region(2)), RegionPair(Region(1), Region(2))}) {
    AgedFilm stage(double_bubble(12));
    for (Vertex v : stage.mesh.vertices())
      for (PairCirculation& held : stage.circulation.at(v))
        if (held.pair == source) held.value = std::sin(5.0 * v.index());
    Diffusion diffusion(10);
    for (int i = 0; i < 10; ++i) stage.diffuse(diffusion, 0.05);
    for (Vertex v : stage.mesh.vertices())
      for (const PairCirculation& held : stage.circulation.at(v))
        if (held.pair != source) {
          EXPECT_EQ(held.value, 0);
        }
  }
}

TEST(Diffusion, ToTheEndLeavesNoDifferenceOnAFilm) {
  AgedFilm stage(double_bubble(8));
  double value = 0;
  for (Vertex v : stage.mesh.vertices())
    for (PairCirculation& held : stage.circulation.at(v)) held.value = std::sin(value += 7);
  Diffusion diffusion(10);
  for (int i = 0; i < 3000; ++i) stage.diffuse(diffusion, 0.05);
  for (Vertex v : stage.mesh.vertices())
    for (const PairCirculation& held : stage.circulation.at(v)) EXPECT_NEAR(held.value, 0, 1e-12);
}

std::vector<Vec3> velocities(const AgedFilm& stage) {
  std::vector<SheetTriangle> sheet;
  gather_sheet(stage.mesh, stage.circulation, sheet);
  std::vector<Vec3> u(stage.mesh.vertex_slots());
  SheetVelocity(make_biot_savart("direct")).evaluate(sheet, stage.mesh.positions(), stage.mesh.positions(), 0.1, u);
  return u;
}

TEST(Diffusion, TakingMeansAwayChangesNoVelocity) {
  AgedFilm stage(double_bubble(12));
  for (Vertex v : stage.mesh.vertices())
    for (PairCirculation& held : stage.circulation.at(v))
      held.value = 20.0 * held.pair.high.index() + std::sin(3.0 * v.index());
  const auto before = velocities(stage);
  Diffusion almost_none(1e-200);
  stage.diffuse(almost_none, 1);
  const auto after = velocities(stage);
  double fastest = 0;
  for (const Vec3& u : before) fastest = std::max(fastest, u.norm());
  ASSERT_GT(fastest, 0.1);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((after[i] - before[i]).norm(), 1e-12 * fastest);
}

}  // namespace
}  // namespace foamsim
