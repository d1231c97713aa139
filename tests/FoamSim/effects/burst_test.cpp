// When which bubble bursts, what is left of the films, and their circulation.

#include "FoamSim/effects/burst.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/burst_transfer.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_burst.h"
#include "LosTopos/shapes/sphere_layout.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

struct Surface {
  explicit Surface(SurfaceMesh films) : mesh(std::move(films)) { geometry.update(mesh); }
  EffectStep at(double time, double dt = 0.01) const { return {mesh, geometry, time, dt}; }
  SurfaceMesh mesh;
  SurfaceGeometry geometry;
};

TEST(BurstRegion, LeavesTheOtherBubbleWhole) {
  SurfaceMesh mesh = double_bubble(12);
  const double volume = lostopos::region_volumes(mesh)[1].volume;
  std::size_t broken = 0, others = 0;
  for (lostopos::Triangle t : mesh.triangles())
    (mesh.labels(t).has(Region(2)) && mesh.labels(t).has(air) ? broken : others) += 1;
  const lostopos::Vec3 centre = lostopos::burst_region(mesh, Region(2));
  EXPECT_EQ(mesh.triangle_count(), others);
  EXPECT_GT(broken, 100U);
  EXPECT_GT(centre.x(), 0.2) << "the right bubble's cap";
  EXPECT_EQ(lostopos::regions(mesh), (std::vector<Region>{air, Region(1)}));
  EXPECT_TRUE(lostopos::audit(mesh).clean()) << lostopos::audit(mesh).text();
  EXPECT_NEAR(lostopos::region_volumes(mesh)[1].volume, volume, 1e-12);
  EXPECT_EQ(lostopos::junction_edge_count(mesh), 0U);
  EXPECT_THROW(lostopos::burst_region(mesh, air), base::InputError);
}

double value(const CirculationField& circulation, Vertex v, unsigned p, unsigned q) {
  return circulation.get(v, {Region(p), Region(q)});
}

bool has(const SurfaceMesh& mesh, Vertex v, unsigned p, unsigned q) {
  return std::ranges::any_of(mesh.triangles(v), [&](lostopos::Triangle t) {
    return mesh.labels(t).has(Region(p)) && mesh.labels(t).has(Region(q));
  });
}

TEST(BurstTransfer, JoinsTheFilmsByTheMeansOverTheirBorder) {
  SurfaceMesh mesh = double_bubble(8);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& entry : circulation.at(v))
      entry.value = std::sin(1.7 * v.index() + 5 * entry.pair.low.index() + 2 * entry.pair.high.index());
  // 2 bursts: its only other neighbour is 1.
  double outside = 0, inside = 0;
  int border = 0;
  for (Vertex v : mesh.vertices())
    if (has(mesh, v, 0, 1) && has(mesh, v, 2, 1)) {
      outside += value(circulation, v, 0, 1);
      inside += value(circulation, v, 2, 1);
      ++border;
    }
  ASSERT_GT(border, 4);
  const double half = (outside - inside) / border / 2;
  std::map<Vertex, double> expected;
  for (Vertex v : mesh.vertices()) {
    if (has(mesh, v, 0, 1) && has(mesh, v, 2, 1))
      expected[v] = (value(circulation, v, 0, 1) + value(circulation, v, 2, 1)) / 2;
    else if (has(mesh, v, 0, 1))
      expected[v] = value(circulation, v, 0, 1) - half;
    else if (has(mesh, v, 2, 1))
      expected[v] = value(circulation, v, 2, 1) + half;
  }
  join_circulation_to_air(mesh, Region(2), circulation);
  lostopos::burst_region(mesh, Region(2));
  circulation.match(mesh);
  ASSERT_EQ(expected.size(), mesh.vertex_count());
  for (Vertex v : mesh.vertices()) {
    ASSERT_EQ(circulation.at(v).size(), 1U);
    EXPECT_NEAR(value(circulation, v, 0, 1), expected.at(v), 1e-14);
  }
}

TEST(BurstEffect, BurstsEveryIntervalFromItsStartOn) {
  const Surface films(double_bubble(8));
  Burst burst({.start = 0.5, .interval = 0.25, .regions = {Region(1), Region(2)}});
  burst.begin(films.at(0));
  std::vector<double> times;
  for (int i = 0; i < 200; ++i)
    if (!burst.bursts(films.at(i * 0.01)).empty()) times.push_back(i * 0.01);
  ASSERT_EQ(times.size(), 2U);
  EXPECT_DOUBLE_EQ(times[0], 0.5);
  EXPECT_DOUBLE_EQ(times[1], 0.75);
}

TEST(BurstEffect, BurstsAtListedTimes) {
  const Surface films(double_bubble(8));
  Burst burst({.times = {0.013, 0.3}, .regions = {Region(2), Region(1)}});
  EXPECT_TRUE(burst.bursts(films.at(0.01)).empty());
  EXPECT_EQ(burst.bursts(films.at(0.02)), std::vector<Region>{Region(2)});
  EXPECT_TRUE(burst.bursts(films.at(0.03)).empty());
  EXPECT_EQ(burst.bursts(films.at(0.3)), std::vector<Region>{Region(1)});
  EXPECT_TRUE(burst.bursts(films.at(100)).empty());
}

TEST(BurstEffect, ChoosesEveryRegionAtTheAirAlikeAndAsTheSeedSays) {
  const Surface films(lostopos::sphere_meshes(lostopos::sphere_layout({.spheres = 5})));
  std::map<Region, int> count;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Burst one({.start = 0, .seed = seed}), again({.start = 0, .seed = seed});
    const std::vector<Region> chosen = one.bursts(films.at(0));
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen, again.bursts(films.at(0)));
    ++count[chosen[0]];
  }
  ASSERT_EQ(count.size(), 5U);
  for (const auto& [region, times] : count) EXPECT_NEAR(times, 100, 40) << region.index();
}

TEST(BurstEffect, GoesOnFromItsStateAsIfItHadNotStopped) {
  const Surface films(lostopos::sphere_meshes(lostopos::sphere_layout({.spheres = 5})));
  const BurstSchedule schedule{.start = 0, .interval = 0.1, .seed = 3};
  Burst one(schedule), other(schedule);
  for (double time : {0.0, 0.1, 0.2}) one.bursts(films.at(time));
  other.restore(one.state());
  EXPECT_EQ(other.state(), one.state());
  EXPECT_TRUE(other.bursts(films.at(0.25)).empty());
  EXPECT_EQ(other.bursts(films.at(0.3)), one.bursts(films.at(0.3)));
}

TEST(BurstEffect, LeavesTheLastBubble) {
  const Surface films(lostopos::sphere_meshes(lostopos::sphere_layout({.spheres = 1})));
  Burst burst({.start = 0});
  EXPECT_TRUE(burst.bursts(films.at(1)).empty());
}

TEST(BurstEffect, RefusesRegionsThatAreNotThere) {
  const Surface films(double_bubble(8));
  Burst burst({.regions = {Region(7)}});
  EXPECT_THROW(burst.begin(films.at(0)), base::InputError);
  EXPECT_THROW(Burst({.regions = {air}}), base::InputError);
  EXPECT_THROW(Burst({.regions = {Region(1), Region(1)}}), base::InputError);
  EXPECT_THROW(Burst({.times = {1, 2}, .regions = {Region(1)}}), base::InputError);
  EXPECT_THROW(Burst({.times = {2, 1}}), base::InputError);
}

}  // namespace
}  // namespace foamsim
