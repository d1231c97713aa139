#pragma once

#include <boost/container/small_vector.hpp>
#include <span>

#include "FoamSim/sheet/region_pair.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/operation_events.h"

namespace foamsim {

/// Γ of one region pair at one vertex, for the order (pair.low, pair.high); L²/T.
struct PairCirculation {
  RegionPair pair;
  double value;
};

/// The circulation Γ_v^{pq} of METHOD "State" (Da et al. 2015): the potential jump between regions p and q at vertex v,
/// held only for the pairs that have a triangle at v. One value on a film, three on a Plateau border, six at a Plateau
/// vertex: memory grows with the vertices, not with the number of regions.
class CirculationField {
 public:
  using VertexValues = boost::container::small_vector<PairCirculation, 1>;

  /// Γ = 0 for every pair that meets at a vertex of `mesh`, which must outlive the field's use.
  explicit CirculationField(lostopos::SurfaceMesh& mesh);

  /// Γ_v^{pq}; 0 where v has no film between p and q.
  double get(lostopos::Vertex v, lostopos::Labels pq) const;
  /// Sets Γ_v^{pq} (and with it Γ_v^{qp}), adding the pair where v does not hold it.
  void set(lostopos::Vertex v, lostopos::Labels pq, double value);
  /// The pairs held at v, sorted.
  std::span<const PairCirculation> at(lostopos::Vertex v) const { return {values_[v].data(), values_[v].size()}; }
  std::span<PairCirculation> at(lostopos::Vertex v) { return {values_[v].data(), values_[v].size()}; }

  /// The mean of what the place's vertices hold: of each pair over those that hold it, by their weights.
  VertexValues mean(const lostopos::Place& place) const;
  /// Makes v hold these, sorted by pair.
  void assign(lostopos::Vertex v, VertexValues values) { values_[v] = std::move(values); }

  /// Gives v those of `values` for which it has a triangle but holds no value yet.
  void add_missing(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v, const VertexValues& values);

  /// Makes every vertex hold exactly the pairs that have a triangle there: others are dropped. A missing one (p, q)
  /// becomes the mean of the neighbours that hold it; where none does, Γ^{pr} + Γ^{rq} of the vertex itself, averaged
  /// over the regions r between (jumps of the potential add up); else 0. Call after the connectivity changed.
  void match(const lostopos::SurfaceMesh& mesh);
  /// The same for these vertices only.
  void match(const lostopos::SurfaceMesh& mesh, std::span<const lostopos::Vertex> vertices);

  /// Bytes of all values, on and off the heap.
  std::size_t memory_bytes() const;

 private:
  double value_of_new_pair(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v, RegionPair pair) const;

  lostopos::VertexAttribute<VertexValues> values_;
};

/// For each pair (1 − t) a + t b, or the value of the one that holds it.
CirculationField::VertexValues interpolate(const CirculationField::VertexValues& a,
                                           const CirculationField::VertexValues& b, double t);

/// Γ^{pq} at the three corners of t, for t's own labels (p, q).
std::array<double, 3> corner_circulation(const lostopos::SurfaceMesh& mesh, const CirculationField& circulation,
                                         lostopos::Triangle t);

}  // namespace foamsim
