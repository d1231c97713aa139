// Two bubbles that fly towards each other, and what becomes of them when they meet.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/two_bubbles.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

TEST(HeadonBubbles, AreMirrorImagesAtTheAskedDistance) {
  const SurfaceMesh mesh = two_bubbles(2, 0.3);
  EXPECT_EQ(mesh.triangle_count(), 640U);
  double left = -10, right = 10;
  for (Vertex v : mesh.vertices()) {
    const double x = mesh.position(v).x();
    (x < 0 ? left : right) = x < 0 ? std::max(left, x) : std::min(right, x);
  }
  EXPECT_NEAR(left, -0.15, 1e-12);
  EXPECT_NEAR(right, 0.15, 1e-12);
  const auto volumes = lostopos::region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_GT(volumes[1].volume, 0);
  EXPECT_NEAR(volumes[1].volume, volumes[2].volume, 1e-12);
  EXPECT_TRUE(lostopos::audit(mesh).clean());
}

// Centre of the air in region 1.
Vec3 centre_of_left_bubble(const SurfaceMesh& mesh) {
  Vec3 moment = Vec3::Zero();
  double volume = 0;
  for (Triangle t : mesh.triangles()) {
    if (!mesh.labels(t).has(Region(1))) continue;
    const auto [a, b, c] = lostopos::corners(mesh, t);
    const double part = (mesh.labels(t).p == Region(1) ? 1 : -1) * a.dot(b.cross(c)) / 6;
    volume += part;
    moment += part * (a + b + c) / 4;
  }
  return moment / volume;
}

struct FirstStep {
  double speed, kinetic_energy;  // over what is asked for
};

// Far apart and without tension.
FirstStep first_step_of_flight(long n) {
  Scene scene = built_in_scene("headon");
  for (auto [key, value] : {std::pair{"gap", 6.0}, {"speed", 0.5}, {"sigma", 0.0}, {"diffusion", 0.0}})
    scene.options.set(key, value, "test");
  scene.options.set("n", n, "test");
  Simulation simulation = make_simulation(scene);
  const Vec3 start = centre_of_left_bubble(simulation.mesh());
  const StepReport report = simulation.step();
  const Vec3 velocity = (centre_of_left_bubble(simulation.mesh()) - start) / 0.01;
  EXPECT_LT(std::hypot(velocity.y(), velocity.z()), 1e-9);
  EXPECT_LT(report.impulse.norm(), 1e-10 * report.impulse_scale);
  // Of a ball of air and the added mass of half a ball, twice: (3/2) (4π/3) U²/2.
  return {velocity.x() / 0.5, report.kinetic_energy / (2 * std::numbers::pi * 0.25)};
}

// They keep the speed that they are given, but for the regularisation's error of first order in h̄.
TEST(HeadonBubbles, FlyTowardsEachOtherAtTheAskedSpeed) {
  const FirstStep coarse = first_step_of_flight(2), fine = first_step_of_flight(3);
  EXPECT_NEAR(fine.speed, 1, 0.2);
  EXPECT_NEAR((1 - fine.speed) / (1 - coarse.speed), 0.5, 0.12);
  EXPECT_NEAR(2 * fine.speed - coarse.speed, 1, 0.04);
  EXPECT_NEAR(2 * fine.kinetic_energy - coarse.kinetic_energy, 1, 0.04);
}

using Films = std::map<RegionPair, double>;

Films film_areas(const SurfaceMesh& mesh) {
  Films films;
  for (Triangle t : mesh.triangles()) films[RegionPair(mesh.labels(t))] += lostopos::area(mesh, t);
  return films;
}

// The Plateau border as a closed line: the number of its edges if it is one cycle, else 0.
std::size_t length_of_single_cycle(const SurfaceMesh& mesh) {
  std::map<Vertex, std::vector<Vertex>> next;
  std::size_t edges = 0;
  for (Edge e : mesh.edges()) {
    if (!mesh.is_junction(e)) continue;
    if (mesh.triangles(e).size() != 3) return 0;
    const auto [a, b] = mesh.vertices(e);
    next[a].push_back(b);
    next[b].push_back(a);
    ++edges;
  }
  if (next.empty()) return 0;
  for (const auto& [v, near] : next)
    if (near.size() != 2) return 0;
  std::size_t walked = 0;
  Vertex before, at = next.begin()->first;
  do {
    const Vertex to = next[at][0] == before ? next[at][1] : next[at][0];
    before = at;
    at = to;
    ++walked;
  } while (at != next.begin()->first && walked <= edges);
  return walked == edges ? edges : 0;
}

TEST(HeadonScene, MeetAndBecomeAStandardDoubleBubble) {
  Scene scene = built_in_scene("headon");
  scene.options.set("n", 3L, "test");
  scene.options.append("effects", "damping", "test");
  scene.options.set("damping", 0.2, "test");
  Simulation simulation = make_simulation(scene);
  const auto start = closed_region_volumes(simulation.mesh());
  std::size_t snaps = 0;
  while (simulation.time() < 4) {
    const StepReport report = simulation.step();
    snaps += report.topology[lostopos::TopologyOperation::snap].done;
    const lostopos::AuditReport audit = lostopos::audit(simulation.mesh());
    ASSERT_TRUE(audit.clean()) << "step " << simulation.steps() << "\n" << audit.text();
    ASSERT_TRUE(std::isfinite(report.kinetic_energy));
  }
  const SurfaceMesh& mesh = simulation.mesh();
  EXPECT_GT(snaps, 0U);
  EXPECT_EQ(simulation.topology_totals().snaps, snaps);
  const Films films = film_areas(mesh);
  ASSERT_EQ(films.size(), 3U) << "two caps and one wall";
  const double wall = films.at(RegionPair(Region(1), Region(2)));
  EXPECT_GE(length_of_single_cycle(mesh), 12U) << "one circle of Plateau border";
  EXPECT_EQ(lostopos::euler_characteristic(mesh), 3) << "three discs with a common rim";
  const auto volumes = closed_region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_LT(largest_volume_drift(volumes, start), 0.03);
  // In equilibrium the caps are spheres of a radius r with 9π r³/8 = V, and the wall a disc of radius r √3/2.
  const double r = std::cbrt(8 * (volumes[1].volume + volumes[2].volume) / 2 / (9 * std::numbers::pi));
  EXPECT_NEAR(wall / (std::numbers::pi * 0.75 * r * r), 1, 0.1);
  EXPECT_NEAR(lostopos::total_area(mesh) / (27 * std::numbers::pi / 4 * r * r), 1, 0.02);
}

std::vector<std::uint64_t> bits_of_meeting(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Scene scene = built_in_scene("headon");
  scene.options.set("n", 2L, "test");
  Simulation simulation = make_simulation(scene);
  for (int i = 0; i < 140; ++i) simulation.step();
  EXPECT_GT(simulation.topology_totals().snaps, 0U) << "they have met within these steps";
  std::vector<std::uint64_t> bits;
  for (Vertex v : simulation.mesh().vertices()) {
    for (double x : simulation.mesh().position(v)) bits.push_back(std::bit_cast<std::uint64_t>(x));
    for (const PairCirculation& held : simulation.circulation().at(v))
      bits.push_back(std::bit_cast<std::uint64_t>(held.value));
  }
  return bits;
}

TEST(HeadonScene, HasTheSameBitsWithOneAndTwoThreads) {
  EXPECT_TRUE(bits_of_meeting(1) == bits_of_meeting(2));
}

}  // namespace
}  // namespace foamsim
