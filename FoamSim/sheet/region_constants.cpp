#include "FoamSim/sheet/region_constants.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>
#include <numeric>

#include "Base/lists/erase_repeated.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

// All films between the regions low < high together; circulation in that order.
struct PairSum {
  double area = 0, circulation_area = 0;
};
using SumsOfPairs = std::map<RegionPair, PairSum>;

double area(const SheetTriangle& t, std::span<const Vec3> positions) {
  const Vec3& a = positions[t.vertices[0].index()];
  return 0.5 * (positions[t.vertices[1].index()] - a).cross(positions[t.vertices[2].index()] - a).norm();
}

SumsOfPairs sum_over_pairs(const SurfaceMesh& mesh, std::span<const SheetTriangle> sheet,
                           std::span<const Vec3> positions) {
  SumsOfPairs sums;
  for (const SheetTriangle& t : sheet) {
    const lostopos::Labels labels = mesh.labels(t.triangle);
    const double a = area(t, positions);
    PairSum& sum = sums[RegionPair(labels)];
    sum.area += a;
    sum.circulation_area += a * RegionPair::sign(labels) * t.mean_circulation();
  }
  std::erase_if(sums, [](const auto& entry) { return !(entry.second.area > 0); });
  return sums;
}

// One constant a region. In every connected group of regions the lowest one has the constant 0: differences are all
// that counts, and the system for the others is then positive definite.
class RegionConstants {
 public:
  explicit RegionConstants(const SumsOfPairs& sums) {
    for (const auto& [pair, sum] : sums) regions_.insert(regions_.end(), {pair.low, pair.high});
    base::sort_unique(regions_);
    find_groups(sums);
    solve(sums);
  }

  double difference(lostopos::Labels labels) const { return constant(labels.p) - constant(labels.q); }

 private:
  double constant(Region r) const {
    const auto it = std::ranges::lower_bound(regions_, r);
    return it != regions_.end() && *it == r ? constants_[it - regions_.begin()] : 0.0;
  }

  int place(Region r) const { return static_cast<int>(std::ranges::lower_bound(regions_, r) - regions_.begin()); }

  int root(int i) const {
    while (lowest_[i] != i) i = lowest_[i];
    return i;
  }

  void find_groups(const SumsOfPairs& sums) {
    lowest_.resize(regions_.size());
    std::iota(lowest_.begin(), lowest_.end(), 0);
    for (const auto& [pair, sum] : sums) {
      const auto [low, high] = std::minmax({root(place(pair.low)), root(place(pair.high))});
      lowest_[high] = low;
    }
  }

  void solve(const SumsOfPairs& sums) {
    const auto n = static_cast<Eigen::Index>(regions_.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (const auto& [pair, sum] : sums) {
      const int p = place(pair.low), q = place(pair.high);
      const bool p_free = lowest_[p] != p, q_free = lowest_[q] != q;
      if (p_free) entries.emplace_back(p, p, sum.area);
      if (q_free) entries.emplace_back(q, q, sum.area);
      if (p_free && q_free) entries.emplace_back(std::max(p, q), std::min(p, q), -sum.area);
      if (p_free) right[p] += sum.circulation_area;
      if (q_free) right[q] -= sum.circulation_area;
    }
    for (int i = 0; i < n; ++i)
      if (lowest_[i] == i) entries.emplace_back(i, i, 1.0);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    constants_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>(matrix).solve(right);
  }

  std::vector<Region> regions_;
  std::vector<int> lowest_;  // union-find forest; a group's lowest region is its own root
  Eigen::VectorXd constants_;
};

}  // namespace

std::vector<double> circulation_without_region_constants(const SurfaceMesh& mesh, std::span<const SheetTriangle> sheet,
                                                         std::span<const Vec3> positions) {
  const RegionConstants constants(sum_over_pairs(mesh, sheet, positions));
  std::vector<double> result;
  result.reserve(sheet.size());
  for (const SheetTriangle& t : sheet)
    result.push_back(t.mean_circulation() - constants.difference(mesh.labels(t.triangle)));
  return result;
}

}  // namespace foamsim
