#include "FoamSim/effects/volumes.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "LosTopos/mesh/for_each_living.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr int newton_steps = 2;

Vec3 area_vector(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> x) {
  const auto [a, b, c] = mesh.vertices(t);
  return 0.5 * (x[b.index()] - x[a.index()]).cross(x[c.index()] - x[a.index()]);
}

// The volumes that are to be kept. Not of bubbles that a solid closes: air goes through that.
std::map<Region, double> bubbles_of(const SurfaceMesh& mesh) {
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

// The closed bubbles of a surface with its vertices anywhere: numbers of the rows, volumes, and gradients.
class Bubbles {
 public:
  Bubbles(const SurfaceMesh& mesh, const std::map<Region, double>& wanted) : mesh_(mesh) {
    for (const auto& [region, volume] : wanted) {
      rows_[region] = static_cast<int>(wanted_.size());
      wanted_.push_back(volume);
    }
  }

  // −1 for a region that is none of them.
  int row(Region r) const {
    const auto it = rows_.find(r);
    return it == rows_.end() ? -1 : it->second;
  }

  Eigen::VectorXd missing(std::span<const Vec3> x) const {
    Eigen::VectorXd missing =
        Eigen::Map<const Eigen::VectorXd>(wanted_.data(), static_cast<Eigen::Index>(wanted_.size()));
    // From a vertex on, so that a bubble far away is as exact as one at the origin.
    Vec3 from = Vec3::Zero();
    for (Vertex v : mesh_.vertices()) {
      from = x[v.index()];
      break;
    }
    for (Triangle t : mesh_.triangles()) {
      const double part = area_vector(mesh_, t, x).dot(x[mesh_.vertices(t)[0].index()] - from) / 3;
      if (const int p = row(mesh_.labels(t).p); p >= 0) missing[p] -= part;
      if (const int q = row(mesh_.labels(t).q); q >= 0) missing[q] += part;
    }
    return missing;
  }

  // ∂V_r/∂x_v of the bubbles at v, and a third of the area around it.
  struct Star {
    std::vector<std::pair<int, Vec3>> gradients;
    double area = 0;
  };
  Star star(Vertex v, std::span<const Vec3> x) const {
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
      const Vec3 normal = area_vector(mesh_, t, x);
      add(row(mesh_.labels(t).p), normal / 3);
      add(row(mesh_.labels(t).q), -normal / 3);
      star.area += normal.norm() / 3;
    }
    return star;
  }

 private:
  const SurfaceMesh& mesh_;
  std::map<Region, int> rows_;
  std::vector<double> wanted_;
};

}  // namespace

void Volumes::attach(SurfaceMesh& mesh) {
  wanted_ = bubbles_of(mesh);
}

void Volumes::velocity_added(const Stage& stage, std::span<const Vec3> added) {
  if (stage.time != stage.step.time) return;
  for (Triangle t : stage.step.mesh.triangles()) {
    Vec3 mean = Vec3::Zero();
    for (Vertex v : stage.step.mesh.vertices(t)) mean += added[v.index()] / 3;
    const double change = stage.step.dt * mean.dot(area_vector(stage.step.mesh, t, stage.positions));
    if (const auto it = wanted_.find(stage.step.mesh.labels(t).p); it != wanted_.end()) it->second += change;
    if (const auto it = wanted_.find(stage.step.mesh.labels(t).q); it != wanted_.end()) it->second -= change;
  }
}

void Volumes::volume_let_in(Region region, double volume) {
  if (const auto it = wanted_.find(region); it != wanted_.end()) it->second += volume;
}

void Volumes::follow(const SurfaceMesh& mesh) {
  const std::map<Region, double> now = bubbles_of(mesh);
  for (const auto& [gone, had] : wanted_) {
    if (now.contains(gone)) continue;
    for (const auto& [region, volume] : now)
      if (const auto it = wanted_.find(region); it != wanted_.end() && volume - it->second > 0.5 * had)
        it->second += had;
  }
  std::erase_if(wanted_, [&now](const auto& entry) { return !now.contains(entry.first); });
  wanted_.insert(now.begin(), now.end());
}

void Volumes::move_vertices(const Stage& stage, std::span<Vec3> positions) {
  // Stages of an integrator are on the way; what counts is where the step ends.
  if (stage.time < stage.step.time + 0.999 * stage.step.dt) return;
  follow(stage.step.mesh);
  correct(stage.step, positions);
}

bool Volumes::settle(const EffectStep& step, std::span<Vec3> positions) {
  constexpr double negligible = 1e-6;
  follow(step.mesh);
  const Eigen::VectorXd missing = Bubbles(step.mesh, wanted_).missing(positions);
  Eigen::Index row = 0;
  bool all_right = true;
  for (const auto& [region, volume] : wanted_)
    all_right = std::abs(missing[row++]) <= negligible * std::abs(volume) && all_right;
  if (!all_right) correct(step, positions);
  return !all_right;
}

void Volumes::correct(const EffectStep& at, std::span<Vec3> positions) const {
  const SurfaceMesh& mesh = at.mesh;
  const Bubbles bubbles(mesh, wanted_);
  const auto rows = static_cast<Eigen::Index>(wanted_.size());
  for (int step = 0; step < newton_steps && rows > 0; ++step) {
    std::vector<Bubbles::Star> stars(mesh.vertex_slots());
    lostopos::for_each_vertex(mesh, [&](Vertex v) {
      if (!at.is_held(v)) stars[v.index()] = bubbles.star(v, positions);
    });
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& star : stars)
      for (const auto& [r, a] : star.gradients)
        for (const auto& [s, b] : star.gradients)
          entries.emplace_back(r, s, star.area > 0 ? a.dot(b) / star.area : 0.0);
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) return;
    const Eigen::VectorXd factors = solver.solve(bubbles.missing(positions));
    if (!factors.allFinite()) return;
    lostopos::for_each_vertex(mesh, [&](Vertex v) {
      const auto& star = stars[v.index()];
      for (const auto& [r, a] : star.gradients)
        if (star.area > 0) positions[v.index()] += factors[r] / star.area * a;
    });
  }
}

nlohmann::json Volumes::state() const {
  nlohmann::json state = nlohmann::json::array();
  for (const auto& [region, volume] : wanted_) state.push_back({region.index(), volume});
  return state;
}

void Volumes::restore(const nlohmann::json& state) {
  std::map<Region, double> wanted;
  for (const auto& entry : state) wanted[Region(entry.at(0).get<std::uint32_t>())] = entry.at(1).get<double>();
  wanted_ = std::move(wanted);
}

}  // namespace foamsim
