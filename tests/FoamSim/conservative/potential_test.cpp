#include "FoamSim/conservative/potential.h"

#include <gtest/gtest.h>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/region_pair.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/surface_tracker.h"
#include "tests/FoamSim/conservative/film_system.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

TEST(VertexPotentials, MixWhateverTheirConstants) {
  const VertexPotential a{{air, 1}, {Region(1), 3}}, b{{air, 11}, {Region(1), 15}, {Region(2), 20}};
  const VertexPotential mixed = interpolate(a, b, 0.5);
  ASSERT_EQ(mixed.size(), 3U);
  EXPECT_DOUBLE_EQ(mixed[1].value - mixed[0].value, 3) << "half-way between 2 and 4";
  EXPECT_DOUBLE_EQ(mixed[2].value - (mixed[0].value + mixed[1].value) / 2, 7) << "as b has it over the other two";
}

TEST(PotentialField, HandsOutAClosedCirculationAndTakesItBack) {
  SurfaceMesh mesh = double_bubble(8);
  CirculationField circulation(mesh);
  const test::FilmSystem system(mesh);
  const std::vector<double> phi = system.random_phi();
  put_circulation(system.films, phi, circulation);
  for (Vertex v : mesh.vertices()) {
    if (circulation.at(v).size() != 3) continue;
    EXPECT_NEAR(circulation.get(v, {air, Region(1)}) + circulation.get(v, {Region(1), Region(2)}),
                circulation.get(v, {air, Region(2)}), 1e-14);
  }
  std::vector<double> back(phi.size(), 0.0);
  take_circulation(system.films, circulation, back);
  CirculationField again(mesh = double_bubble(8));
  put_circulation(system.films, back, again);
  for (Vertex v : mesh.vertices())
    for (const PairCirculation& pair : again.at(v)) {
      const auto& films = system.films;
      double expected = 0;
      for (std::size_t e = films.first_entry[v.index()]; e < films.first_entry[v.index() + 1]; ++e) {
        if (films.regions[e] == pair.pair.low) expected += phi[e];
        if (films.regions[e] == pair.pair.high) expected -= phi[e];
      }
      EXPECT_NEAR(pair.value, expected, 1e-13);
    }
}

// ∫ Γ^{pq} dA of every film.
std::map<RegionPair, double> integrals(const SurfaceMesh& mesh, const PotentialField& field) {
  SurfaceGeometry geometry;
  geometry.update(mesh);
  FilmConnectivity films;
  films.update(mesh, geometry, {}, {});
  std::vector<double> phi(films.entries());
  field.gather(films, phi);
  std::map<RegionPair, double> sums;
  for (std::size_t t = 0; t < films.triangles.size(); ++t) {
    const auto labels = mesh.labels(films.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k)
      sums[RegionPair(labels)] += RegionPair::sign(labels) * (phi[films.front[t][k]] - phi[films.back[t][k]]) / 3 *
                                  lostopos::area(mesh, films.triangles[t]);
  }
  return sums;
}

// A smooth φ on a coarse mesh that is made coarser still: mostly collapses.
double worst_change(bool conserving) {
  SurfaceMesh start = double_bubble(24);
  lostopos::TrackerOptions options;
  options.resolution = 1.6 * lostopos::mean_edge_length(start);
  lostopos::SurfaceTracker tracker(std::move(start), options);
  PotentialField field(tracker.mesh(), conserving);
  const test::FilmSystem system(tracker.mesh());
  std::vector<double> phi(system.films.entries());
  for (std::size_t v = 0; v < system.films.vertex_slots(); ++v)
    for (std::size_t e = system.films.first_entry[v]; e < system.films.first_entry[v + 1]; ++e)
      phi[e] = system.films.regions[e].index() * (2 + system.x[v].x() * system.x[v].y() + system.x[v].z());
  field.scatter(system.films, phi);
  const auto before = integrals(tracker.mesh(), field);
  const lostopos::RemeshStatistics done = tracker.remesh();
  EXPECT_GT(done[lostopos::Operation::collapse].done, 50U);
  const auto after = integrals(tracker.mesh(), field);
  double worst = 0, size = 0;
  for (const auto& [pair, value] : before) {
    worst = std::max(worst, std::abs(after.at(pair) - value));
    size = std::max(size, std::abs(value));
  }
  return worst / size;
}

TEST(PotentialTransfer, KeepsTheIntegralsOverFilmsThatRemeshingMakesCoarser) {
  const double kept = worst_change(true), carried = worst_change(false);
  EXPECT_LT(kept, 2e-3);
  EXPECT_LT(kept, 0.5 * carried);
}

}  // namespace
}  // namespace foamsim
