#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "LosTopos/collision/impulses.h"
#include "LosTopos/collision/rigid_motion.h"
#include "LosTopos/collision/zone_solver.h"

namespace lostopos {
namespace {

// Points alone: the responses read nothing else of a mesh.
struct Points {
  explicit Points(std::size_t count, unsigned seed) : random(seed) {
    for (std::size_t i = 0; i < count; ++i) mesh.add_vertex(vector());
    for (std::size_t i = 0; i < count; ++i) predicted.push_back(mesh.position(Vertex(i)) + vector());
    held.assign(count, Hold::none);
  }
  double number() { return std::uniform_real_distribution(-1.0, 1.0)(random); }
  Vec3 vector() { return {number(), number(), number()}; }

  Contact contact(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    Contact contact;
    contact.pair.vertices = {Vertex(a), Vertex(b), Vertex(c), Vertex(d)};
    const double s = std::abs(number()), t = std::abs(number());
    contact.weights = {1 - s, s, t - 1, -t};
    contact.normal = vector().normalized();
    contact.target = 0.1 * number();
    return contact;
  }

  SurfaceMesh mesh;
  std::mt19937 random;
  std::vector<Vec3> predicted;
  std::vector<Hold> held;
};

Vec3 sum_of_ends(const Motion& motion) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : motion.ends()) sum += x;
  return sum;
}

TEST(Impulses, VertexIntoTheMiddleOfATriangle) {
  Points points(4, 1);
  points.predicted = {points.mesh.positions().begin(), points.mesh.positions().end()};
  points.predicted[0] -= Vec3::UnitZ();
  Motion motion(points.mesh, points.predicted, points.held);
  Contact contact = points.contact(0, 1, 2, 3);
  contact.weights = {1, -1 / 3.0, -1 / 3.0, -1 / 3.0};
  contact.normal = Vec3::UnitZ();
  contact.target = 0;
  EXPECT_EQ(apply_impulses(motion, std::vector{contact}), 1u);
  // Perfectly inelastic: a quarter of the momentum each.
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(motion.displacement(Vertex(i)).z(), -0.25, 1e-15);
}

TEST(Impulses, HeldVerticesTakeNoneAndTheOthersGiveWay) {
  Points points(4, 2);
  points.held = {Hold::all, Hold::none, Hold::all, Hold::all};
  Motion motion(points.mesh, points.predicted, points.held);
  Contact contact = points.contact(0, 1, 2, 3);
  contact.weights = {0.5, 0.5, -0.25, -0.75};
  contact.target = relative_displacement(motion, contact) + 0.3;
  EXPECT_EQ(apply_impulses(motion, std::vector{contact}), 1u);
  EXPECT_NEAR(relative_displacement(motion, contact), contact.target, 1e-14);
  for (std::size_t i : {0u, 2u, 3u}) EXPECT_EQ(motion.ends()[i], points.predicted[i]);
}

TEST(Impulses, LeverageOnFreeVerticesIsBounded) {
  Points points(4, 3);
  points.held = {Hold::all, Hold::none, Hold::all, Hold::all};
  Motion motion(points.mesh, points.predicted, points.held);
  Contact contact = points.contact(0, 1, 2, 3);
  contact.weights = {1 - 1e-12, 1e-12, -1, 0};
  contact.target = relative_displacement(motion, contact) + 0.5;
  EXPECT_EQ(apply_impulses(motion, std::vector{contact}), 1u);
  EXPECT_LE((motion.ends()[1] - points.predicted[1]).norm(), 4 * 0.5 * (1 + 1e-3));
}

// Against the minimum-norm solution by a complete orthogonal decomposition.
void compare_with_minimum_norm(std::size_t contact_count, unsigned seed) {
  Points points(2 * contact_count + 8, seed);
  const std::size_t n = points.predicted.size();
  for (std::size_t i = 0; i < n; i += 7) points.held[i] = Hold::all;
  std::vector<Contact> contacts;
  for (std::size_t k = 0; k < contact_count; ++k) {
    contacts.push_back(points.contact(2 * k, 2 * k + 3, 2 * k + 4, 2 * k + 7));
  }
  Motion motion(points.mesh, points.predicted, points.held);
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(contact_count), static_cast<Eigen::Index>(3 * n));
  Eigen::VectorXd lacking(static_cast<Eigen::Index>(contact_count));
  for (std::size_t k = 0; k < contact_count; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    lacking[row] = contacts[k].target - relative_displacement(motion, contacts[k]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t v = contacts[k].pair.vertices[i].index();
      if (is_held(points.held[v])) continue;
      rows.block<1, 3>(row, static_cast<Eigen::Index>(3 * v)) +=
          contacts[k].weights[i] * contacts[k].normal.transpose();
    }
  }
  const Eigen::VectorXd change = rows.completeOrthogonalDecomposition().solve(lacking);
  ASSERT_TRUE(solve_contacts(motion, contacts));
  for (std::size_t v = 0; v < n; ++v) {
    const Vec3 expected = points.predicted[v] + change.segment<3>(static_cast<Eigen::Index>(3 * v));
    EXPECT_LT((motion.ends()[v] - expected).norm(), 1e-4) << "vertex " << v;
    if (is_held(points.held[v])) {
      EXPECT_EQ(motion.ends()[v], points.predicted[v]);
    }
  }
}

TEST(ZoneSolver, FewContactsDensely) {
  for (unsigned seed = 0; seed < 5; ++seed) compare_with_minimum_norm(1 + 2 * seed, seed);
}

TEST(ZoneSolver, ManyContactsSparsely) {
  for (unsigned seed = 0; seed < 5; ++seed) compare_with_minimum_norm(13 + 20 * seed, seed);
}

TEST(ZoneSolver, RepeatedContactsDoNoHarmAndMomentumIsKept) {
  Points points(8, 4);
  std::vector<Contact> contacts = {points.contact(0, 1, 2, 3), points.contact(2, 3, 4, 5)};
  for (int i = 0; i < 20; ++i) contacts.push_back(contacts[static_cast<std::size_t>(i) % 2]);
  Motion motion(points.mesh, points.predicted, points.held);
  const Vec3 before = sum_of_ends(motion);
  ASSERT_TRUE(solve_contacts(motion, contacts));
  for (const Contact& contact : contacts) EXPECT_NEAR(relative_displacement(motion, contact), contact.target, 1e-6);
  EXPECT_NEAR((sum_of_ends(motion) - before).norm(), 0, 1e-13);
}

TEST(ZoneSolver, NothingToDoWhenAllAreHeld) {
  Points points(4, 5);
  points.held = {Hold::all, Hold::all, Hold::all, Hold::all};
  Motion motion(points.mesh, points.predicted, points.held);
  EXPECT_FALSE(solve_contacts(motion, std::vector{points.contact(0, 1, 2, 3)}));
}

std::vector<Vertex> all_of(const Points& points) {
  std::vector<Vertex> all;
  for (std::size_t i = 0; i < points.predicted.size(); ++i) all.emplace_back(i);
  return all;
}

TEST(RigidMotion, FollowsARigidRequestExactly) {
  Points points(10, 6);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  for (std::size_t i = 0; i < 10; ++i) points.predicted[i] = turn * points.mesh.position(Vertex(i)) + Vec3(3, 1, 2);
  const std::vector<Vec3> asked = points.predicted;
  Motion motion(points.mesh, points.predicted, points.held);
  move_rigidly(motion, all_of(points));
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR((motion.ends()[i] - asked[i]).norm(), 0, 1e-14);
}

TEST(RigidMotion, KeepsDistancesAndMomentum) {
  Points points(10, 7);
  for (Vec3& x : points.predicted) x = 0.3 * x + 0.1 * points.vector();
  Motion motion(points.mesh, points.predicted, points.held);
  const Vec3 before = sum_of_ends(motion);
  move_rigidly(motion, all_of(points));
  EXPECT_NEAR((sum_of_ends(motion) - before).norm(), 0, 1e-13);
  for (std::size_t i = 1; i < 10; ++i) {
    EXPECT_NEAR((motion.ends()[i] - motion.ends()[0]).norm(), (motion.starts()[i] - motion.starts()[0]).norm(), 1e-13);
  }
}

TEST(RigidMotion, FollowsTheHeldOnes) {
  Points points(6, 8);
  points.held[2] = Hold::all;
  points.held[4] = Hold::all;
  const Vec3 shift(0.5, -0.25, 1);
  for (std::size_t i : {2u, 4u}) points.predicted[i] = points.mesh.position(Vertex(i)) + shift;
  Motion motion(points.mesh, points.predicted, points.held);
  move_rigidly(motion, all_of(points));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR((motion.displacement(Vertex(i)) - shift).norm(), 0, 1e-14);
  EXPECT_EQ(motion.ends()[2], points.predicted[2]);
}

}  // namespace
}  // namespace lostopos
