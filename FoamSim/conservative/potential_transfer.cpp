#include "FoamSim/conservative/potential_transfer.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "FoamSim/linear/dense_solve.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::CollapseEvent;
using lostopos::Edge;
using lostopos::FlipEvent;
using lostopos::MergeEvent;
using lostopos::MoveEvent;
using lostopos::Place;
using lostopos::Region;
using lostopos::SeparationEvent;
using lostopos::SplitEvent;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

namespace {

Eigen::Index place_of(const VertexPotential& potential, Region r) {
  return std::ranges::lower_bound(potential, r, {}, &RegionPotential::region) - potential.begin();
}

}  // namespace

void PotentialTransfer::after_split(const SurfaceMesh& mesh, const SplitEvent& event) {
  value(event.added) = interpolate(value(event.ends[0]), value(event.ends[1]), 0.5);
  match(mesh, event.added);
}

void PotentialTransfer::before_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  touched_.clear();
  touch(mesh, event.removed);
  carried_ = interpolate(value(event.kept), value(event.removed), event.t);
  patch_.assign(mesh.triangles(event.kept).begin(), mesh.triangles(event.kept).end());
  patch_.insert(patch_.end(), mesh.triangles(event.removed).begin(), mesh.triangles(event.removed).end());
  remember(mesh, patch_);
}

void PotentialTransfer::after_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  value(event.kept) = carried_;
  match_touched(mesh);
  conserve(mesh, event.kept);
}

void PotentialTransfer::after_flip(const SurfaceMesh& mesh, const FlipEvent& event) {
  for (Vertex v : event.old_ends) match(mesh, v);
  for (Vertex v : event.new_ends) match(mesh, v);
}

void PotentialTransfer::before_move(const SurfaceMesh& mesh, const MoveEvent& event) {
  patch_.assign(mesh.triangles(event.vertex).begin(), mesh.triangles(event.vertex).end());
  remember(mesh, patch_);
}

void PotentialTransfer::after_move(const SurfaceMesh& mesh, const MoveEvent& event) {
  conserve(mesh, event.vertex);
}

void PotentialTransfer::before_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  touched_.clear();
  patch_.clear();
  for (const Place& place : event.places)
    for (std::size_t i = 0; i < place.count; ++i) {
      touch(mesh, place.vertices[i]);
      patch_.insert(patch_.end(), mesh.triangles(place.vertices[i]).begin(), mesh.triangles(place.vertices[i]).end());
    }
  carried_ = interpolate(mean(event.places[0]), mean(event.places[1]), event.t);
  remember(mesh, patch_);
}

void PotentialTransfer::after_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  if (!mesh.alive(event.result)) return match_touched(mesh);
  value(event.result) = carried_;
  touch(mesh, event.result);
  match_touched(mesh);
  // Places on edges and in triangles leave a patch that is not that of the result alone.
  if (event.places[0].count == 1 && event.places[1].count == 1) conserve(mesh, event.result);
}

void PotentialTransfer::before_separation(const SurfaceMesh& mesh, const SeparationEvent& event) {
  touched_.clear();
  touch(mesh, event.vertex);
  carried_ = value(event.vertex);
}

void PotentialTransfer::after_separation(const SurfaceMesh& mesh, const SeparationEvent& event) {
  value(event.added) = carried_;
  touch(mesh, event.added);
  touch(mesh, event.vertex);
  match_touched(mesh);
}

VertexPotential PotentialTransfer::mean(const Place& place) const {
  VertexPotential mixed = value(place.vertices[0]);
  double weight = place.weights[0];
  for (std::size_t i = 1; i < place.count; ++i) {
    if (!(place.weights[i] > 0)) continue;
    weight += place.weights[i];
    mixed = interpolate(mixed, value(place.vertices[i]), place.weights[i] / weight);
  }
  return mixed;
}

void PotentialTransfer::touch(const SurfaceMesh& mesh, Vertex v) {
  touched_.push_back(v);
  for (Edge e : mesh.edges(v)) touched_.push_back(mesh.other_vertex(e, v));
}

void PotentialTransfer::match_touched(const SurfaceMesh& mesh) {
  base::sort_unique(touched_);
  for (Vertex v : touched_)
    if (mesh.alive(v)) match(mesh, v);
  touched_.clear();
}

void PotentialTransfer::match(const SurfaceMesh& mesh, Vertex v) {
  boost::container::small_vector<Region, 4> regions;
  for (Triangle t : mesh.triangles(v))
    for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) {
      const auto it = std::ranges::lower_bound(regions, r);
      if (it == regions.end() || *it != r) regions.insert(it, r);
    }
  VertexPotential& own = value(v);
  if (std::ranges::equal(regions, own, {}, {}, &RegionPotential::region)) return;
  VertexPotential matched;
  for (Region r : regions) {
    if (const double* held = find(own, r)) {
      matched.push_back({r, *held});
      continue;
    }
    // The mean of the neighbours that hold it, each levelled to this vertex by the regions in common; else no jump.
    VertexPotential near;
    for (Edge e : mesh.edges(v)) {
      const VertexPotential& other = value(mesh.other_vertex(e, v));
      if (find(other, r) == nullptr) continue;
      const VertexPotential levelled = interpolate(own, other, 0);
      near.push_back({r, *find(levelled, r)});
    }
    double sum = 0;
    for (const RegionPotential& entry : near) sum += entry.value;
    if (!near.empty()) sum /= static_cast<double>(near.size());
    if (near.empty() && !own.empty()) {
      for (const RegionPotential& entry : own) sum += entry.value;
      sum /= static_cast<double>(own.size());
    }
    matched.push_back({r, sum});
  }
  own = std::move(matched);
}

double PotentialTransfer::jump(Vertex v, RegionPair pair) const {
  const double* low = find(value(v), pair.low);
  const double* high = find(value(v), pair.high);
  return low != nullptr && high != nullptr ? *low - *high : 0.0;
}

void PotentialTransfer::remember(const SurfaceMesh& mesh, std::vector<Triangle>& patch) {
  sums_.clear();
  if (!conserving_) return;
  base::sort_unique(patch);
  for (Triangle t : patch) {
    const RegionPair pair(mesh.labels(t));
    auto it = std::ranges::find(sums_, pair, &FilmSum::pair);
    const bool first = it == sums_.end();
    if (first) it = sums_.insert(it, {pair});
    const double third = lostopos::area(mesh, t) / 3;
    for (Vertex v : mesh.vertices(t)) {
      const double value = jump(v, pair);
      it->integral += third * value;
      it->low = first && v == mesh.vertices(t)[0] ? value : std::min(it->low, value);
      it->high = first && v == mesh.vertices(t)[0] ? value : std::max(it->high, value);
    }
  }
}

void PotentialTransfer::conserve(const SurfaceMesh& mesh, Vertex v) {
  if (!conserving_ || value(v).size() < 2) return;
  VertexPotential& own = value(v);
  const auto n = static_cast<Eigen::Index>(own.size());
  // Normal equations of Γ^{pq} = target, weighted by the area that the vertex has of the film, held by their sum.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  double total = 0;
  for (const FilmSum& film : sums_) {
    if (find(own, film.pair.low) == nullptr || find(own, film.pair.high) == nullptr) continue;
    double weight = 0, others = 0;
    for (Triangle t : mesh.triangles(v)) {
      if (!(RegionPair(mesh.labels(t)) == film.pair)) continue;
      const double third = lostopos::area(mesh, t) / 3;
      for (Vertex corner : mesh.vertices(t)) {
        if (corner == v)
          weight += third;
        else
          others += third * jump(corner, film.pair);
      }
    }
    if (!(weight > 0)) continue;
    const double target = std::clamp((film.integral - others) / weight, film.low, film.high);
    const auto p = place_of(own, film.pair.low), q = place_of(own, film.pair.high);
    const double change = target - jump(v, film.pair);
    matrix(p, p) += weight;
    matrix(q, q) += weight;
    matrix(p, q) -= weight;
    matrix(q, p) -= weight;
    right[p] += weight * change;
    right[q] -= weight * change;
    total += weight;
  }
  if (!(total > 0)) return;
  matrix.array() += total;
  const Eigen::VectorXd change = solve_symmetric(matrix, right);
  for (Eigen::Index i = 0; i < n; ++i) own[static_cast<std::size_t>(i)].value += change[i];
}

}  // namespace foamsim
