#include "FoamSim/sheet/bubble_volumes.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "LosTopos/mesh/for_each_living.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

Vec3 area_vector_at(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> x) {
  const auto [a, b, c] = mesh.vertices(t);
  return 0.5 * (x[b.index()] - x[a.index()]).cross(x[c.index()] - x[a.index()]);
}

std::map<Region, double> closed_bubbles(const SurfaceMesh& mesh) {
  std::map<Region, double> bubbles;
  for (const auto& [region, volume] : lostopos::closed_region_volumes(mesh))
    if (region != lostopos::air) bubbles[region] = volume;
  for (const lostopos::NamedAttributeColumn* column : mesh.named_triangle_attributes()) {
    if (column->name() != "solid") continue;
    for (Triangle t : mesh.triangles())
      if (column->number(t.index(), 0) != 0)
        for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) bubbles.erase(r);
  }
  return bubbles;
}

BubbleVolumes::BubbleVolumes(const SurfaceMesh& mesh, const std::map<Region, double>& wanted)
    : mesh_(mesh), rows_(mesh.triangle_slots()), wanted_(static_cast<Eigen::Index>(wanted.size())) {
  std::vector<Region> regions;
  for (const auto& [region, volume] : wanted) {
    wanted_[static_cast<Eigen::Index>(regions.size())] = volume;
    regions.push_back(region);
  }
  // No table by region: users number regions up to 2^31.
  const auto row = [&regions](Region r) {
    const auto found = std::ranges::lower_bound(regions, r);
    return found != regions.end() && *found == r ? static_cast<int>(found - regions.begin()) : -1;
  };
  lostopos::for_each_triangle(mesh, [&](Triangle t) {
    rows_[t.index()] = {row(mesh.labels(t).p), row(mesh.labels(t).q)};
  });
}

Eigen::VectorXd BubbleVolumes::missing(std::span<const Vec3> x) const {
  Eigen::VectorXd missing = wanted_;
  // From a vertex on, so that a bubble far away is as exact as one at the origin.
  Vec3 from = Vec3::Zero();
  for (Vertex v : mesh_.vertices()) {
    from = x[v.index()];
    break;
  }
  for (Triangle t : mesh_.triangles()) {
    const double part = area_vector_at(mesh_, t, x).dot(x[mesh_.vertices(t)[0].index()] - from) / 3;
    const auto [p, q] = rows_[t.index()];
    if (p >= 0) missing[p] -= part;
    if (q >= 0) missing[q] += part;
  }
  return missing;
}

BubbleVolumes::Star BubbleVolumes::star(Vertex v, std::span<const Vec3> x) const {
  Star star;
  const auto add = [&star](int row, const Vec3& part) {
    if (row < 0) return;
    for (auto& [own, sum] : star.gradients)
      if (own == row) {
        sum += part;
        return;
      }
    star.gradients.emplace_back(row, part);
  };
  for (Triangle t : mesh_.triangles(v)) {
    const Vec3 normal = area_vector_at(mesh_, t, x);
    const auto [p, q] = rows_[t.index()];
    add(p, normal / 3);
    add(q, -normal / 3);
    star.area += normal.norm() / 3;
  }
  return star;
}

bool BubbleVolumes::update(std::span<const Vec3> x, const std::function<bool(Vertex)>& is_free) {
  stars_.assign(mesh_.vertex_slots(), {});
  lostopos::for_each_vertex(mesh_, [&](Vertex v) {
    if (is_free(v)) stars_[v.index()] = star(v, x);
  });
  std::vector<Eigen::Triplet<double>> entries;
  for (const Star& star : stars_)
    for (const auto& [r, a] : star.gradients)
      for (const auto& [s, b] : star.gradients) entries.emplace_back(r, s, star.area > 0 ? a.dot(b) / star.area : 0.0);
  Eigen::SparseMatrix<double> matrix(rows(), rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(matrix);
  return solver_.info() == Eigen::Success;
}

Eigen::VectorXd BubbleVolumes::solve(const Eigen::VectorXd& b) const {
  const Eigen::VectorXd factors = solver_.solve(b);
  return factors.allFinite() ? factors : Eigen::VectorXd();
}

Eigen::VectorXd BubbleVolumes::product(std::span<const Vec3> w) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(rows());
  for (std::size_t v = 0; v < stars_.size(); ++v)
    for (const auto& [r, a] : stars_[v].gradients)
      if (stars_[v].area > 0) sums[r] += a.dot(w[v]) / stars_[v].area;
  return sums;
}

void BubbleVolumes::add(const Eigen::VectorXd& factors, bool over_area, std::span<Vec3> out) const {
  lostopos::for_each_vertex(mesh_, [&](Vertex v) {
    const Star& star = stars_[v.index()];
    for (const auto& [r, a] : star.gradients)
      if (star.area > 0) out[v.index()] += (over_area ? factors[r] / star.area : factors[r]) * a;
  });
}

}  // namespace foamsim
