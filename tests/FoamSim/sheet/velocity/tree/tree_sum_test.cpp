// Tree sums against direct ones: errors below the tolerance on every kind of surface, symmetry, bits.
#include "FoamSim/sheet/velocity/tree/tree_sum.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "Base/error.h"
#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/tree.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/sphere_layout.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;

struct Sheet {
  VortexSources sources = {};
  double delta = 0;
};

// The sheet of a smooth circulation over a mesh.
Sheet sheet_of(const SurfaceMesh& mesh) {
  Sheet problem{.delta = 0.5 * lostopos::mean_edge_length(mesh)};
  problem.sources.resize(mesh.triangle_count());
  std::size_t t = 0;
  const auto circulation = [](const Vec3& x) { return std::sin(3 * x.x()) + x.y() * x.z(); };
  for (Triangle triangle : mesh.triangles()) {
    const auto [a, b, c] = mesh.vertices(triangle);
    const Vec3 &x = mesh.position(a), &y = mesh.position(b), &z = mesh.position(c);
    problem.sources.set(t++, (x + y + z) / 3,
                        circulation(x) * (z - y) + circulation(y) * (x - z) + circulation(z) * (y - x));
  }
  return problem;
}

SurfaceMesh spheres() {
  return lostopos::sphere_meshes(lostopos::sphere_layout({.spheres = 27}));
}

Sheet flat_sheet() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  constexpr std::size_t n = 6000;
  Sheet problem{.delta = 0.01};
  problem.sources.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const Vec3 x(value(random), value(random), 0);
    problem.sources.set(t, x, Vec3(std::sin(2 * x.y()), std::cos(3 * x.x()), 0) / n);
  }
  return problem;
}

double largest(const std::vector<Vec3>& values) {
  double most = 0;
  for (const Vec3& value : values) most = std::max(most, value.norm());
  return most;
}

double error(const std::vector<Vec3>& values, const std::vector<Vec3>& exact) {
  double most = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) most = std::max(most, (values[i] - exact[i]).norm());
  return most / largest(exact);
}

struct Named {
  const char* name;
  std::function<Sheet()> make;
};

class TreeSumOn : public testing::TestWithParam<Named> {};

TEST_P(TreeSumOn, IsWithinItsTolerance) {
  const Sheet problem = GetParam().make();
  ASSERT_GT(problem.sources.size(), 3000U);
  PairSums exact, sums;
  DirectPairSums(Precision::doubles).evaluate(problem.sources, problem.delta, PairTerms::all, exact);
  for (double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    TreePairSums({.tolerance = tolerance}, Precision::doubles)
        .evaluate(problem.sources, problem.delta, PairTerms::all, sums);
    EXPECT_LT(error(sums.potential, exact.potential), tolerance) << tolerance;
    EXPECT_LT(error(sums.velocity, exact.velocity), tolerance) << tolerance;
    EXPECT_LT(error(sums.force, exact.force), tolerance) << tolerance;
    TreePairSums({.tolerance = tolerance}, Precision::doubles)
        .evaluate(problem.sources, problem.delta, PairTerms::potential, sums);
    EXPECT_LT(error(sums.potential, exact.potential), tolerance) << tolerance << ", alone";
  }
  // A sum that is direct after all would be exact.
  TreePairSums({.tolerance = 1e-3}, Precision::doubles)
      .evaluate(problem.sources, problem.delta, PairTerms::potential, sums);
  EXPECT_GT(error(sums.potential, exact.potential), 1e-9);
  EXPECT_TRUE(sums.velocity.empty());
  EXPECT_TRUE(sums.force.empty());
}

// Places a distance δ beside sources.
std::vector<Vec3> places_beside(const Sheet& problem, std::size_t n) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t t = i % problem.sources.size();
    const double turn = static_cast<double>(i);
    places.emplace_back(problem.sources.x[t] + problem.delta * std::cos(turn),
                        problem.sources.y[t] + problem.delta * std::sin(turn), problem.sources.z[t]);
  }
  return places;
}

std::vector<Vec3> velocities_by(const BiotSavart& sum, const Sheet& problem, std::span<const Vec3> targets) {
  std::vector<Vec3> velocities(targets.size());
  sum.velocities(problem.sources, targets, problem.delta, velocities);
  return velocities;
}

TEST_P(TreeSumOn, GivesVelocitiesElsewhere) {
  const Sheet problem = GetParam().make();
  const std::vector<Vec3> targets = places_beside(problem, 20000);
  const std::vector<Vec3> exact = velocities_by(DirectBiotSavart(), problem, targets);
  for (double tolerance : {1e-3, 1e-4, 1e-5}) {
    const double wrong = error(velocities_by(TreeBiotSavart({.tolerance = tolerance}), problem, targets), exact);
    EXPECT_LT(wrong, tolerance);
    if (tolerance < 1e-3) {
      EXPECT_GT(wrong, tolerance / 1000) << "no clusters have met";
    }
  }
  PairSums all;
  const std::span<const Vec3> at = targets;
  TreeSum().evaluate(problem.sources, &at, problem.delta, TreeTerms::all, TreeAccuracy::of(1e-5, 6000), all);
  EXPECT_LT(error(all.velocity, exact), 1e-5);
  EXPECT_EQ(all.potential.size(), targets.size());
  EXPECT_EQ(largest(all.force), 0) << "targets have no strength";
}

// Clusters would be more work: all points meet, as well as single precision can.
TEST_P(TreeSumOn, TakesFewPointsOneByOne) {
  const Sheet problem = GetParam().make();
  const std::vector<Vec3> targets = places_beside(problem, 200);
  const std::vector<Vec3> exact = velocities_by(DirectBiotSavart(), problem, targets);
  EXPECT_LT(error(velocities_by(TreeBiotSavart({.tolerance = 1e-2}), problem, targets), exact), 3e-5);
}

// Σ γ'·Ψ[γ] = Σ γ·Ψ[γ'] to the rounding of the precision, not to the tolerance.
TEST_P(TreeSumOn, IsSymmetric) {
  const Sheet one = GetParam().make();
  Sheet two = one;
  for (std::size_t t = 0; t < two.sources.size(); ++t)
    two.sources.set(t, Vec3(one.sources.x[t], one.sources.y[t], one.sources.z[t]),
                    Vec3(one.sources.gz[t], -one.sources.gx[t], one.sources.x[t] * one.sources.gy[t]));
  const auto product = [](const VortexSources& sources, const PairSums& sums) {
    double sum = 0;
    for (std::size_t t = 0; t < sources.size(); ++t)
      sum += Vec3(sources.gx[t], sources.gy[t], sources.gz[t]).dot(sums.potential[t]);
    return sum;
  };
  PairSums of_one, of_two;
  for (bool single : {false, true}) {
    const TreeAccuracy accuracy{.nodes = 4, .openness = 0.7, .single_near = single, .single_far = single};
    TreeSum().evaluate(one.sources, nullptr, one.delta, TreeTerms::potential, accuracy, of_one);
    TreeSum().evaluate(two.sources, nullptr, two.delta, TreeTerms::potential, accuracy, of_two);
    const double scale = std::sqrt(product(one.sources, of_one) * product(two.sources, of_two));
    EXPECT_NEAR(product(two.sources, of_one), product(one.sources, of_two), (single ? 1e-6 : 1e-13) * scale);
  }
}

TEST_P(TreeSumOn, HasTheSameBitsWithAnyNumberOfThreads) {
  const Sheet problem = GetParam().make();
  PairSums one, two;
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    TreeSum().evaluate(problem.sources, nullptr, problem.delta, TreeTerms::all, TreeAccuracy::of(1e-4, 6000), one);
  }
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  TreeSum().evaluate(problem.sources, nullptr, problem.delta, TreeTerms::all, TreeAccuracy::of(1e-4, 6000), two);
  EXPECT_EQ(one.potential, two.potential);
  EXPECT_EQ(one.velocity, two.velocity);
  EXPECT_EQ(one.force, two.force);
}

// Strengths change under clusters that stay; other points, another δ and another accuracy get clusters of their own.
TEST_P(TreeSumOn, HasTheSameBitsWhateverItHasSummedBefore) {
  const Sheet problem = GetParam().make();
  Sheet other = problem;
  for (std::size_t t = 0; t < other.sources.size(); ++t) other.sources.gx[t] = -3 * other.sources.gx[t] + 1e-3;
  Sheet moved = problem;
  moved.sources.z[7] += 0.01;
  const std::vector<Vec3> elsewhere{Vec3(0.1, 0.2, 0.3)};
  const std::span<const Vec3> targets = elsewhere;
  const TreeAccuracy fine = TreeAccuracy::of(1e-5, 6000), coarse = TreeAccuracy::of(1e-3, 6000);
  TreeSum summed;
  const auto expect_as_anew = [&](const Sheet& sheet, const std::span<const Vec3>* at, double delta, TreeTerms terms,
                                  const TreeAccuracy& accuracy, const char* what) {
    PairSums again, anew;
    summed.evaluate(sheet.sources, at, delta, terms, accuracy, again);
    TreeSum().evaluate(sheet.sources, at, delta, terms, accuracy, anew);
    EXPECT_EQ(again.potential, anew.potential) << what;
    EXPECT_EQ(again.velocity, anew.velocity) << what;
    EXPECT_EQ(again.force, anew.force) << what;
  };
  const double delta = problem.delta;
  expect_as_anew(problem, nullptr, delta, TreeTerms::all, fine, "first");
  expect_as_anew(other, nullptr, delta, TreeTerms::potential, fine, "other strengths");
  expect_as_anew(moved, nullptr, delta, TreeTerms::all, fine, "a point moved");
  expect_as_anew(moved, nullptr, 2 * delta, TreeTerms::all, fine, "another regularisation");
  expect_as_anew(moved, nullptr, 2 * delta, TreeTerms::all, coarse, "another accuracy");
  expect_as_anew(moved, &targets, 2 * delta, TreeTerms::velocity, coarse, "targets of its own");
  expect_as_anew(problem, nullptr, delta, TreeTerms::all, fine, "as at first");
}

INSTANTIATE_TEST_SUITE_P(Surfaces, TreeSumOn,
                         testing::Values(Named{"sphere", [] { return sheet_of(lostopos::icosphere(4)); }},
                                         Named{"spheres", [] { return sheet_of(spheres()); }},
                                         Named{"foam",
                                               [] { return sheet_of(lostopos::voronoi_foam({.subdivisions = 2})); }},
                                         Named{"flat_sheet", flat_sheet}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TreeSums, WithoutRegularisationLeavesOwnPointsOut) {
  VortexSources sources;
  sources.resize(2);
  sources.set(0, Vec3(0, 0, 0), Vec3(0, 0, 1));
  sources.set(1, Vec3(1, 0, 0), Vec3(0, 0, 2));
  const std::vector<Vec3> targets{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  std::vector<Vec3> tree(2), direct(2);
  TreeBiotSavart({.tolerance = 1e-8}).velocities(sources, targets, 0, tree);
  DirectBiotSavart().velocities(sources, targets, 0, direct);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT((tree[i] - direct[i]).norm(), 1e-14);
}

TEST(TreeSums, OfNothingIsNothing) {
  const std::vector<Vec3> targets(3, Vec3::Ones());
  std::vector<Vec3> out(3, Vec3::Ones());
  TreeBiotSavart({}).velocities({}, targets, 0.1, out);
  EXPECT_EQ(out, std::vector<Vec3>(3, Vec3::Zero()));
  PairSums sums;
  TreePairSums({}, Precision::doubles).evaluate({}, 0.1, PairTerms::all, sums);
  EXPECT_TRUE(sums.potential.empty());
}

TEST(TreeSums, RefusesABadRegularisation) {
  const Sheet problem = flat_sheet();
  PairSums sums;
  for (double delta : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(TreePairSums({}, Precision::doubles).evaluate(problem.sources, delta, PairTerms::all, sums),
                 base::InputError);
}

TEST(TreeAccuracy, TakesMoreForLess) {
  std::size_t nodes = 0;
  for (double tolerance = 1e-2; tolerance > 0.9e-8; tolerance /= 10) {
    const TreeAccuracy accuracy = TreeAccuracy::of(tolerance, 1000);
    EXPECT_GE(accuracy.nodes, nodes);
    EXPECT_GE(accuracy.openness, 0.6);
    EXPECT_LE(accuracy.openness, 0.76);
    nodes = accuracy.nodes;
  }
  EXPECT_LE(nodes, most_nodes);
}

TEST(AutomaticSum, IsDirectForFewAndByTreeForMany) {
  const Sheet few = sheet_of(lostopos::icosphere(2)), many = sheet_of(lostopos::icosphere(4));
  for (const Sheet* problem : {&few, &many}) {
    const std::vector<Vec3> targets(10, Vec3(0.1, 0.2, 0.3));
    std::vector<Vec3> automatic(10), direct(10), tree(10);
    const TreeOptions options{.direct_where_few = true};
    TreeBiotSavart(options).velocities(problem->sources, targets, problem->delta, automatic);
    TreeBiotSavart({}).velocities(problem->sources, targets, problem->delta, tree);
    DirectBiotSavart().velocities(problem->sources, targets, problem->delta, direct);
    EXPECT_EQ(automatic, problem == &few ? direct : tree);
    EXPECT_NE(direct, tree);
  }
  const auto potential = [](PairSummation&& sums, const Sheet& problem) {
    PairSums result;
    sums.evaluate(problem.sources, problem.delta, PairTerms::potential, result);
    return result.potential;
  };
  EXPECT_LT(few_for_velocities({}), many.sources.size());
  // Sums over pairs are direct for longer.
  EXPECT_GT(few_for_pairs({}), many.sources.size());
  EXPECT_EQ(potential(TreePairSums({.direct_where_few = true}, Precision::doubles), many),
            potential(DirectPairSums(), many));
  const Sheet large = sheet_of(lostopos::icosphere(5));
  EXPECT_LT(few_for_pairs({}), large.sources.size());
  EXPECT_EQ(potential(TreePairSums({.direct_where_few = true}, Precision::doubles), large),
            potential(TreePairSums({}, Precision::doubles), large));
}

}  // namespace
}  // namespace foamsim
