#include "FoamSim/sheet/velocity/tree/pair_orders.h"

#include <algorithm>
#include <cmath>

namespace foamsim {

namespace {

constexpr std::size_t few_nodes = 3, least_nodes = 2;
// Half a cluster's side over the radii of the pair: a cube's is 0.29 of them where both clusters are alike; this is
// what a node was measured to be worth (TreeAccuracy::of).
constexpr double side = 0.32;

// s for a pair with this openness: the other's ball ends half of the radii before its middle.
double nearest_source(double openness) {
  return (1 - openness / 2) / (side * openness);
}

double log_rate(double s) {
  return -std::log(s + std::sqrt(std::max(0.0, s * s - 1)));
}

// The openness at which the rate is exp(log_rate).
double openness_of(double log_rate) {
  return 1 / (0.5 + side * std::cosh(log_rate));
}

}  // namespace

PairOrders::PairOrders(const TreeAccuracy& accuracy) : fewest_(std::min(few_nodes, accuracy.nodes)) {
  const double error = static_cast<double>(accuracy.nodes - 1) * log_rate(nearest_source(accuracy.openness));
  for (std::size_t nodes = fewest_; nodes < accuracy.nodes; ++nodes)
    reach_.push_back(openness_of(error / static_cast<double>(nodes - 1)));
  reach_.push_back(accuracy.openness);
}

std::size_t PairOrders::order(double openness) const {
  const auto found = std::ranges::lower_bound(reach_, openness);
  return std::min<std::size_t>(static_cast<std::size_t>(found - reach_.begin()), reach_.size() - 1);
}

GridShape PairOrders::shape(std::size_t order, const lostopos::Vec3& half) const {
  const std::size_t most = nodes(order);
  const double s = nearest_source(reach_[order]), error = static_cast<double>(most - 1) * log_rate(s);
  const double longest = half.maxCoeff();
  GridShape shape{most, most, most};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double own = half[static_cast<Eigen::Index>(axis)];
    if (!(own > 0) || own == longest) continue;
    const double needed = error / log_rate(s * longest / own);
    shape[axis] = std::clamp<std::size_t>(1 + static_cast<std::size_t>(std::ceil(needed - 1e-9)), least_nodes, most);
  }
  return shape;
}

}  // namespace foamsim
