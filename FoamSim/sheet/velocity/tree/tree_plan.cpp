#include "FoamSim/sheet/velocity/tree/tree_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <type_traits>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/tree/cluster_grid.h"
#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"
#include "FoamSim/sheet/velocity/tree/near_velocity.h"
#include "FoamSim/sheet/velocity/tree/pair_grid.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

Vec3 place(const VortexSources& sources, std::size_t t) {
  return {sources.x[t], sources.y[t], sources.z[t]};
}

std::vector<Vec3> points_of(const VortexSources& sources) {
  std::vector<Vec3> points(sources.size());
  for (std::size_t t = 0; t < points.size(); ++t) points[t] = place(sources, t);
  return points;
}

// What lengths are divided by, so that singles can hold them: δ, or the size of the whole.
double unit_of_length(std::span<const Vec3> points, double delta) {
  if (delta > 0) return delta;
  Vec3 low = points[0], high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).maxCoeff();
  return size > 0 ? size : 1;
}

double unit_of_strength(const VortexSources& sources) {
  double strongest = 0;
  for (std::size_t t = 0; t < sources.size(); ++t)
    strongest = std::max({strongest, std::abs(sources.gx[t]), std::abs(sources.gy[t]), std::abs(sources.gz[t])});
  return strongest > 0 ? strongest : 1;
}

// Points of a tree in its order, each from the middle of its leaf; without strengths unless they take some.
template <class Real>
struct Places {
  TreeArray<Real> x, y, z, gx, gy, gz;

  Places(const ClusterTree& tree, std::span<const Vec3> points, double unit) {
    for (TreeArray<Real>* array : {&x, &y, &z, &gx, &gy, &gz}) array->assign(points.size() + tree_lanes, Real{0});
    for (const Cluster& cluster : tree.clusters())
      for (std::uint32_t i = cluster.begin; cluster.leaf() && i < cluster.end; ++i) {
        const Vec3 from_middle = (points[tree.order()[i]] - cluster.middle) / unit;
        x[i] = static_cast<Real>(from_middle.x());
        y[i] = static_cast<Real>(from_middle.y());
        z[i] = static_cast<Real>(from_middle.z());
      }
  }

  void take_strengths(const ClusterTree& tree, const VortexSources& sources, double unit) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      gx[i] = static_cast<Real>(sources.gx[tree.order()[i]] / unit);
      gy[i] = static_cast<Real>(sources.gy[tree.order()[i]] / unit);
      gz[i] = static_cast<Real>(sources.gz[tree.order()[i]] / unit);
    }
  }

  TreeBodies<Real> of(const Cluster& c) const {
    const auto at = [&c](const TreeArray<Real>& array) { return array.data() + c.begin; };
    return {at(x), at(y), at(z), at(gx), at(gy), at(gz), c.size()};
  }
};

// Points as near ones and as parts of clusters, and the clusters' grids.
template <class Near, class Far>
struct Side {
  ClusterTree tree;
  Places<Near> near;
  Places<Far> far;
  std::vector<HalfSides> half;
  std::vector<PairGrids<Far>> grids;  // by order; none where clusters never meet as wholes

  Side(std::span<const Vec3> points, std::size_t leaf_size, double length)
      : tree(points, leaf_size),
        near(tree, points, length),
        far(tree, points, length),
        half(half_sides(tree, length)) {}

  void make_grids(const PairOrders& orders, double length) {
    for (std::size_t order = 0; order < orders.count(); ++order) grids.emplace_back(tree, orders, order, length);
  }
};

template <class Near, class Far>
class PlanOf final : public TreePlan {
 public:
  PlanOf(const VortexSources& sources, const std::span<const Vec3>* targets, double delta, const TreeAccuracy& accuracy)
      : TreePlan(sources, targets, delta, accuracy),
        nodes_(accuracy.nodes),
        orders_(accuracy),
        transfers_(nodes_),
        length_(unit_of_length(points_, delta)),
        // Leaves have as many points as a grid: others, smaller and larger ones, win nothing.
        from_(points_, grid_size(nodes_), length_) {
    if (targets_) own_.emplace(*targets_, grid_size(nodes_), length_);
    pairs_.emplace(to().tree, from_.tree, orders_);
    by_clusters_ = !targets_ || !are_few();
    if (by_clusters_)
      make_grids();
    else
      pairs_ = ClusterPairs::of_leaves(to().tree, from_.tree);
  }

  void sum(const VortexSources& sources, TreeTerms terms, const base::Ranks& ranks, PairSums& result) override {
    const double strength = unit_of_strength(sources);
    from_.near.take_strengths(from_.tree, sources, strength);
    if constexpr (std::is_same_v<Near, float>)
      if (takes_moments(terms)) near_sources_ = near_sources(from_.near.of(from_.tree[0]));
    if (by_clusters_) gather(sources, strength);
    out_.assign(components(terms) * stride(), 0.0);
    const Share own = share(ranks);
    meet(own, terms);
    if (by_clusters_) {
      ranks.gather(potentials_);
      spread_to_children(to().tree, nodes_, potentials_);
      arrive(own, terms);
    }
    ranks.gather(out_);
    hand_over(terms, std::numbers::inv_pi / 4 * strength / length_, strength, result);
  }

 private:
  // Whether it is less work to let all points meet. Not asked for a tree's points among themselves: that sum is
  // symmetric, and DirectPairSums does it with half of the work.
  bool are_few() const {
    const double all = static_cast<double>(targets_->size()) * static_cast<double>(points_.size());
    return all <= pairs_->cost(to().tree, from_.tree, orders_);
  }

  void make_grids() {
    from_.make_grids(orders_, length_);
    if (own_) own_->make_grids(orders_, length_);
  }

  // Clusters of targets, from the first to the last less one.
  struct Share {
    std::size_t begin, end;
  };

  // As much of the work for each rank as can be, counted in pairs of points.
  Share share(const base::Ranks& ranks) const {
    const std::size_t count = pairs_->far.size();
    if (ranks.size() == 1) return {0, count};
    std::vector<double> until{0};
    for (std::size_t t = 0; t < count; ++t) {
      const auto c = static_cast<std::uint32_t>(t);
      double met = 0;
      for (std::uint32_t s : pairs_->near[t]) met += static_cast<double>(to().tree[c].size()) * from_.tree[s].size();
      for (const ClusterPairs::Far& far : pairs_->far[t])
        met += static_cast<double>(std::min<std::size_t>(to().tree[c].size(), to().grids[far.order].size(c))) *
               static_cast<double>(
                   std::min<std::size_t>(from_.tree[far.source].size(), from_.grids[far.order].size(far.source)));
      until.push_back(until.back() + met);
    }
    const auto first = [&](std::size_t rank) {
      if (rank == ranks.size()) return count;
      const double wanted = until.back() * static_cast<double>(rank) / static_cast<double>(ranks.size());
      return static_cast<std::size_t>(std::ranges::lower_bound(until, wanted) - until.begin());
    };
    return {first(ranks.rank()), first(ranks.rank() + 1)};
  }

  bool takes_moments(TreeTerms terms) const { return accuracy_.near_moments && terms == TreeTerms::velocity; }

  // The strengths as charges of the clusters' grids, and room for what these meet.
  void gather(const VortexSources& sources, double strength) {
    from_.far.take_strengths(from_.tree, sources, strength);
    gather_charges<Far>(from_.tree, from_.half, from_.far.of(Cluster()), nodes_, charges_);
    for (PairGrids<Far>& grids : from_.grids) grids.lower_charges(transfers_, charges_);
    potentials_.assign(to().tree.clusters().size() * 3 * grid_size(nodes_), 0.0);
  }

  const Side<Near, Far>& to() const { return own_ ? *own_ : from_; }
  std::size_t stride() const { return to().far.x.size(); }
  // A grid is met by potentials alone, single points by all terms, which is twice the work. Sources go by the same
  // rule, so that the operator is symmetric.
  static bool by_grid(const Side<Near, Far>& side, std::uint32_t c, std::size_t order, TreeTerms terms) {
    const Cluster& cluster = side.tree[c];
    return !cluster.leaf() || (terms == TreeTerms::potential ? 1 : 2) * cluster.size() > side.grids[order].size(c);
  }

  // Orders are those that slopes want; a potential alone is as good with one node less.
  static std::size_t order_of(const ClusterPairs::Far& far, TreeTerms terms) {
    const std::size_t less = terms == TreeTerms::potential ? 1 : 0;
    return std::max<std::size_t>(far.order, less) - less;
  }

  TreeBodies<Far> source(const ClusterPairs::Far& far, TreeTerms terms) const {
    const std::size_t order = order_of(far, terms);
    if (!by_grid(from_, far.source, order, terms)) return from_.far.of(from_.tree[far.source]);
    return from_.grids[order].bodies(far.source);
  }

  std::array<double, 3> offset(const Cluster& target, std::uint32_t s) const {
    const Vec3 apart = (target.middle - from_.tree[s].middle) / length_;
    return {apart.x(), apart.y(), apart.z()};
  }

  void meet(const Share& own, TreeTerms terms) {
    const double delta_squared = delta_ * delta_ / (length_ * length_);
    base::parallel_for_each(own.end - own.begin, 1, [&](std::size_t i) {
      const auto t = static_cast<std::uint32_t>(own.begin + i);
      const Cluster& cluster = to().tree[t];
      if (!pairs_->far[t].empty())
        for (std::size_t order = 0; order < orders_.count(); ++order) meet_far(t, order, terms, delta_squared);
      for (std::uint32_t s : pairs_->near[t]) meet_near(cluster, s, terms, delta_squared);
    });
  }

  void meet_near(const Cluster& target, std::uint32_t s, TreeTerms terms, double delta_squared) {
    const Cluster& source = from_.tree[s];
    const auto apart = offset(target, s);
    double* arrived = out_.data() + target.begin;
    if constexpr (std::is_same_v<Near, float>)
      if (takes_moments(terms) && are_near_enough(std::hypot(apart[0], apart[1], apart[2]), target.radius / length_,
                                                  source.radius / length_, delta_ / length_))
        return add_near_velocities(to().near.of(target), std::span(near_sources_).subspan(source.begin, source.size()),
                                   apart, delta_squared, arrived, stride());
    add_to_targets(to().near.of(target), from_.near.of(source), apart, delta_squared, terms, arrived, stride());
  }

  // Cluster t with all that it meets by grids of an order.
  void meet_far(std::uint32_t t, std::size_t order, TreeTerms terms, double delta_squared) {
    const Cluster& cluster = to().tree[t];
    const PairGrids<Far>& grids = to().grids[order];
    const bool as_grid = by_grid(to(), t, order, terms);
    std::vector<double> potential;
    for (const ClusterPairs::Far& far : pairs_->far[t]) {
      if (order_of(far, terms) != order) continue;
      const auto apart = offset(cluster, far.source);
      if (!as_grid) {
        add_to_targets(to().far.of(cluster), source(far, terms), apart, delta_squared, terms,
                       out_.data() + cluster.begin, stride());
        continue;
      }
      potential.resize(3 * grids.stride());
      add_to_targets(grids.bodies(t), source(far, terms), apart, delta_squared, TreeTerms::potential, potential.data(),
                     grids.stride());
    }
    if (!potential.empty())
      grids.raise(transfers_, t, potential.data(), potentials_.data() + 3 * grid_size(nodes_) * t);
  }

  // From the leaves' grids to their points.
  void arrive(const Share& own, TreeTerms terms) {
    const Side<Near, Far>& side = to();
    base::parallel_for_each(own.end - own.begin, 1, [&](std::size_t i) {
      const auto t = static_cast<std::uint32_t>(own.begin + i);
      const Cluster& cluster = side.tree[t];
      if (cluster.leaf())
        add_interpolated(side.half[t], side.far.of(cluster), nodes_, potentials_.data() + 3 * grid_size(nodes_) * t,
                         terms, out_.data() + cluster.begin, stride());
    });
  }

  // `scale`: of Ψ, in the problem's units.
  void hand_over(TreeTerms terms, double scale, double strength, PairSums& result) const {
    const auto order = to().tree.order();
    const auto fill = [&](std::vector<Vec3>& array, std::size_t first, double unit) {
      array.resize(order.size());
      const double* x = out_.data() + first * stride();
      base::parallel_for_each(order.size(), 1024, [&](std::size_t i) {
        array[order[i]] = unit * Vec3(x[i], x[stride() + i], x[2 * stride() + i]);
      });
    };
    if (terms != TreeTerms::velocity) fill(result.potential, 0, scale);
    if (terms != TreeTerms::potential) fill(result.velocity, terms == TreeTerms::all ? 3 : 0, scale / length_);
    if (terms == TreeTerms::all) fill(result.force, 6, scale / length_ * strength);
  }

  Chebyshev nodes_;
  PairOrders orders_;
  GridTransfers transfers_;
  double length_;
  Side<Near, Far> from_;
  std::optional<Side<Near, Far>> own_;
  std::optional<ClusterPairs> pairs_;
  bool by_clusters_ = true;
  std::vector<NearSource> near_sources_;  // for velocities in single precision
  TreeArray<Far> charges_;
  std::vector<double> out_, potentials_;
};

}  // namespace

TreePlan::TreePlan(const VortexSources& sources, const std::span<const Vec3>* targets, double delta,
                   const TreeAccuracy& accuracy)
    : points_(points_of(sources)), delta_(delta), accuracy_(accuracy) {
  if (targets != nullptr) targets_.emplace(targets->begin(), targets->end());
}

std::unique_ptr<TreePlan> TreePlan::make(const VortexSources& sources, const std::span<const Vec3>* targets,
                                         double delta, const TreeAccuracy& accuracy) {
  if (accuracy.single_near && accuracy.single_far)
    return std::make_unique<PlanOf<float, float>>(sources, targets, delta, accuracy);
  if (accuracy.single_near) return std::make_unique<PlanOf<float, double>>(sources, targets, delta, accuracy);
  return std::make_unique<PlanOf<double, double>>(sources, targets, delta, accuracy);
}

bool TreePlan::fits(const VortexSources& sources, const std::span<const Vec3>* targets, double delta,
                    const TreeAccuracy& accuracy) const {
  if (delta != delta_ || accuracy != accuracy_ || points_.size() != sources.size()) return false;
  if ((targets != nullptr) != targets_.has_value()) return false;
  if (targets != nullptr && !std::ranges::equal(*targets, *targets_)) return false;
  for (std::size_t t = 0; t < points_.size(); ++t)
    if (points_[t] != place(sources, t)) return false;
  return true;
}

}  // namespace foamsim
