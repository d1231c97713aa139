// What tree sums are made of: interpolants, clusters, and which of them meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"
#include "FoamSim/sheet/velocity/tree/pair_grid.h"

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
  const ClusterPairs pairs(targets, sources, PairOrders({.nodes = 6, .openness = openness}));
  const std::size_t n = sources.order().size();
  std::vector<int> count(targets.order().size() * n, 0);
  const auto meet = [&](std::uint32_t t, std::uint32_t s) {
    for (std::uint32_t i = targets[t].begin; i < targets[t].end; ++i)
      for (std::uint32_t j = sources[s].begin; j < sources[s].end; ++j)
        ++count[targets.order()[i] * n + sources.order()[j]];
  };
  for (std::uint32_t t = 0; t < targets.clusters().size(); ++t) {
    for (const ClusterPairs::Far& far : pairs.far[t]) meet(t, far.source);
    for (std::uint32_t s : pairs.near[t]) meet(t, s);
  }
  return count;
}

TEST(ClusterPairs, LetEachPairOfPointsMeetOnce) {
  const ClusterTree one(cloud(300, 1), 10), two(cloud(200, 2), 7);
  EXPECT_EQ(meetings(one, one, 0.7), std::vector<int>(90000, 1));
  EXPECT_EQ(meetings(one, two, 0.5), std::vector<int>(60000, 1));
}

TEST(ClusterPairs, OfATreeWithItselfAreMutual) {
  const ClusterTree tree(cloud(500, 3), 10);
  const ClusterPairs pairs(tree, tree, PairOrders({.nodes = 6, .openness = 0.7}));
  std::size_t far = 0;
  for (std::uint32_t t = 0; t < tree.clusters().size(); ++t) {
    far += pairs.far[t].size();
    for (const auto& [s, order] : pairs.far[t]) {
      const auto back = std::ranges::find(pairs.far[s], t, &ClusterPairs::Far::source);
      ASSERT_NE(back, pairs.far[s].end());
      EXPECT_EQ(back->order, order) << "so that the operator is symmetric";
      EXPECT_LE(tree[t].radius + tree[s].radius, 0.7 * (tree[t].middle - tree[s].middle).norm());
    }
    for (std::uint32_t s : pairs.near[t]) EXPECT_EQ(std::ranges::count(pairs.near[s], t), 1);
  }
  EXPECT_GT(far, 100U);
}

TEST(PairOrders, FallWithDistanceAndAlongShortSides) {
  const PairOrders orders({.nodes = 8, .openness = 0.65});
  EXPECT_EQ(orders.nodes(orders.count() - 1), 8U);
  EXPECT_EQ(orders.order(0.65), orders.count() - 1);
  EXPECT_EQ(orders.nodes(orders.order(0)), 3U);
  for (double openness = 0.01; openness < 0.65; openness += 0.01)
    EXPECT_LE(orders.order(openness - 0.01), orders.order(openness));
  for (std::size_t order = 0; order < orders.count(); ++order) {
    const std::size_t most = orders.nodes(order);
    EXPECT_EQ(orders.shape(order, Vec3(1, 1, 1)), (GridShape{most, most, most}));
    const GridShape flat = orders.shape(order, Vec3(1, 0.1, 2));
    EXPECT_EQ(flat[2], most);
    EXPECT_LE(flat[0], most);
    EXPECT_LE(flat[1], flat[0]);
  }
  EXPECT_LT(orders.shape(orders.count() - 1, Vec3(1, 0.1, 1))[1], 7U);
}

// The points of a grid in a box, and the values of their polynomials at x.
struct WeightedGrid {
  std::vector<Vec3> places;
  std::vector<double> weights;
};

WeightedGrid weighted_grid(const GridShape& shape, const Vec3& half, const Vec3& x) {
  std::vector<Chebyshev> nodes;
  std::array<Chebyshev::Values, 3> values{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    nodes.emplace_back(shape[axis]);
    nodes[axis].values(x[a] / half[a], values[axis]);
  }
  WeightedGrid grid;
  for (std::size_t a = 0; a < shape[0]; ++a)
    for (std::size_t b = 0; b < shape[1]; ++b)
      for (std::size_t c = 0; c < shape[2]; ++c) {
        grid.places.emplace_back(half[0] * nodes[0].node(a), half[1] * nodes[1].node(b), half[2] * nodes[2].node(c));
        grid.weights.push_back(values[0][a] * values[1][b] * values[2][c]);
      }
  return grid;
}

// The potential of a charge in one box at a point of another by both grids, against itself: the largest error of
// some, relative to the largest.
double error_by_grids(const PairOrders& orders, double openness, const Vec3& half, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  const Vec3 apart = Vec3(value(random), value(random), value(random)).normalized() * 2 * half.norm() / openness;
  const GridShape shape = orders.shape(orders.order(openness), half);
  double worst = 0, largest = 0;
  for (int i = 0; i < 5; ++i) {
    const auto point = [&] { return half.cwiseProduct(Vec3(value(random), value(random), value(random))).eval(); };
    const Vec3 source = point(), target = point();
    const WeightedGrid from = weighted_grid(shape, half, source), to = weighted_grid(shape, half, target);
    const double exact = 1 / (target + apart - source).norm();
    double sum = 0;
    for (std::size_t t = 0; t < to.places.size(); ++t)
      for (std::size_t s = 0; s < from.places.size(); ++s)
        sum += to.weights[t] * from.weights[s] / (to.places[t] + apart - from.places[s]).norm();
    worst = std::max(worst, std::abs(sum - exact));
    largest = std::max(largest, exact);
  }
  return worst / largest;
}

TEST(PairOrders, KeepTheErrorOfTheNearestPair) {
  const PairOrders orders({.nodes = 6, .openness = 0.6});
  for (const Vec3& half : {Vec3(1, 1, 1), Vec3(1, 1, 0.1), Vec3(1, 0.3, 0.1)}) {
    double nearest = 0;
    for (unsigned seed = 0; seed < 8; ++seed) nearest = std::max(nearest, error_by_grids(orders, 0.6, half, seed));
    EXPECT_LT(nearest, 5e-4);
    for (double openness : {0.5, 0.4, 0.3, 0.2, 0.1})
      for (unsigned seed = 0; seed < 8; ++seed)
        EXPECT_LT(error_by_grids(orders, openness, half, seed), 1e-3) << openness << " " << half.transpose();
  }
}

TEST(GridTransfers, GoBackTheWayTheyCame) {
  const Chebyshev nodes(6);
  const GridTransfers transfers(nodes);
  const PairOrders orders({.nodes = 6, .openness = 0.6});
  const ClusterTree tree(cloud(40, 5), 40);
  const std::size_t full = 216;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> charges(3 * full), raised(3 * full, 0.0);
  for (double& q : charges) q = value(random);
  for (std::size_t order = 0; order < orders.count(); ++order) {
    PairGrids<double> grids(tree, orders, order, 1);
    grids.lower_charges(transfers, charges);
    std::vector<double> potential(3 * grids.stride());
    for (double& p : potential) p = value(random);
    std::ranges::fill(raised, 0.0);
    grids.raise(transfers, 0, potential.data(), raised.data());
    const TreeBodies<double> lowered = grids.bodies(0);
    const std::array<const double*, 3> parts{lowered.gx, lowered.gy, lowered.gz};
    double above = 0, below = 0;
    for (std::size_t part = 0; part < 3; ++part) {
      for (std::size_t i = 0; i < full; ++i) above += charges[part * full + i] * raised[part * full + i];
      for (std::size_t i = 0; i < lowered.size; ++i) below += parts[part][i] * potential[part * grids.stride() + i];
    }
    EXPECT_NEAR(above, below, 1e-11) << order;
  }
}

}  // namespace
}  // namespace foamsim
