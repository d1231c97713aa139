// What tree sums are made of: interpolants, clusters, and which of them meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

std::vector<Vec3> cloud(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<Vec3> points(n);
  for (Vec3& point : points) point = Vec3(value(random), value(random), 0.2 * value(random));
  return points;
}

double power(double s, std::size_t degree) {
  return std::pow(s, static_cast<double>(degree));
}

TEST(ChebyshevInterpolant, OfAPolynomialIsThePolynomial) {
  for (std::size_t n : {2U, 3U, 6U, 16U}) {
    const Chebyshev nodes(n);
    for (std::size_t degree = 0; degree < n; ++degree)
      for (double s : {-1.0, -0.9, -1e-9, 0.0, 0.3, nodes.node(1), nodes.node(1) + 1e-13, 1.0}) {
        Chebyshev::Values values{}, slopes{};
        nodes.values(s, values);
        nodes.slopes(values, slopes);
        double value = 0, slope = 0;
        for (std::size_t k = 0; k < n; ++k) {
          value += values[k] * power(nodes.node(k), degree);
          slope += slopes[k] * power(nodes.node(k), degree);
        }
        const double exact = degree == 0 ? 0 : static_cast<double>(degree) * power(s, degree - 1);
        EXPECT_NEAR(value, power(s, degree), 1e-13) << n << " " << degree << " " << s;
        EXPECT_NEAR(slope, exact, 1e-11) << n << " " << degree << " " << s;
      }
  }
}

TEST(ClusterTree, PutsEachPointIntoOneLeafInsideItsBox) {
  const std::vector<Vec3> points = cloud(1000, 1);
  const ClusterTree tree(points, 20);
  std::set<std::uint32_t> seen;
  for (const Cluster& cluster : tree.clusters()) {
    for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
      const Vec3 from_middle = (points[tree.order()[i]] - cluster.middle).cwiseAbs();
      EXPECT_LE((from_middle - cluster.half).maxCoeff(), 1e-12);
      if (cluster.leaf()) {
        EXPECT_TRUE(seen.insert(tree.order()[i]).second);
      }
    }
    if (cluster.leaf()) {
      EXPECT_LE(cluster.size(), 20U);
      continue;
    }
    const Cluster &one = tree[cluster.child], &two = tree[cluster.child + 1];
    EXPECT_EQ(one.begin, cluster.begin);
    EXPECT_EQ(one.end, two.begin);
    EXPECT_EQ(two.end, cluster.end);
    for (const Cluster* child : {&one, &two})
      EXPECT_LE(((child->middle - cluster.middle).cwiseAbs() + child->half - cluster.half).maxCoeff(), 1e-12);
  }
  EXPECT_EQ(seen.size(), points.size());
}

TEST(ClusterTree, OfPointsInOnePlaceIsALeaf) {
  const ClusterTree tree(std::vector<Vec3>(100, Vec3(1, 2, 3)), 10);
  ASSERT_EQ(tree.clusters().size(), 1U);
  EXPECT_TRUE(tree[0].leaf());
  EXPECT_EQ(tree[0].size(), 100U);
}

// How often each target meets each source.
std::vector<int> meetings(const ClusterTree& targets, const ClusterTree& sources, double openness) {
  const ClusterPairs pairs(targets, sources, openness);
  const std::size_t n = sources.order().size();
  std::vector<int> count(targets.order().size() * n, 0);
  for (std::uint32_t t = 0; t < targets.clusters().size(); ++t)
    for (const auto* list : {&pairs.far[t], &pairs.near[t]})
      for (std::uint32_t s : *list)
        for (std::uint32_t i = targets[t].begin; i < targets[t].end; ++i)
          for (std::uint32_t j = sources[s].begin; j < sources[s].end; ++j)
            ++count[targets.order()[i] * n + sources.order()[j]];
  return count;
}

TEST(ClusterPairs, LetEachPairOfPointsMeetOnce) {
  const ClusterTree one(cloud(300, 1), 10), two(cloud(200, 2), 7);
  EXPECT_EQ(meetings(one, one, 0.7), std::vector<int>(90000, 1));
  EXPECT_EQ(meetings(one, two, 0.5), std::vector<int>(60000, 1));
}

TEST(ClusterPairs, OfATreeWithItselfAreMutual) {
  const ClusterTree tree(cloud(500, 3), 10);
  const ClusterPairs pairs(tree, tree, 0.7);
  std::size_t far = 0;
  for (std::uint32_t t = 0; t < tree.clusters().size(); ++t) {
    far += pairs.far[t].size();
    for (std::uint32_t s : pairs.far[t]) {
      EXPECT_EQ(std::ranges::count(pairs.far[s], t), 1);
      EXPECT_LE(tree[t].radius + tree[s].radius, 0.7 * (tree[t].middle - tree[s].middle).norm());
    }
    for (std::uint32_t s : pairs.near[t]) EXPECT_EQ(std::ranges::count(pairs.near[s], t), 1);
  }
  EXPECT_GT(far, 100U);
}

}  // namespace
}  // namespace foamsim
