#pragma once

#include <span>

#include "FoamSim/sheet/circulation_values.h"

namespace foamsim {

/// The circulation Γ_v^{pq} of docs/method.md "State" (Da et al. 2015): the potential jump between regions p and q at
/// vertex v, held only for the pairs that have a triangle at v. One value on a film, three on a Plateau border, six at
/// a Plateau vertex: memory grows with the vertices, not with the number of regions.
class CirculationField {
 public:
  /// Of `mesh`, which must outlive the field's use: its attribute "circulation", carried through operations by
  /// CirculationTransfer. Γ = 0 for every pair that meets at a vertex, unless values of that name wait in the mesh.
  explicit CirculationField(lostopos::SurfaceMesh& mesh);

  /// Γ_v^{pq}; 0 where v has no film between p and q.
  double get(lostopos::Vertex v, lostopos::Labels pq) const;
  /// Sets Γ_v^{pq} (and with it Γ_v^{qp}), adding the pair where v does not hold it.
  void set(lostopos::Vertex v, lostopos::Labels pq, double value);
  /// The pairs held at v, sorted.
  std::span<const PairCirculation> at(lostopos::Vertex v) const { return {values_[v].data(), values_[v].size()}; }
  std::span<PairCirculation> at(lostopos::Vertex v) { return {values_[v].data(), values_[v].size()}; }

  /// Makes every vertex hold exactly the pairs that have a triangle there: others are dropped. A missing one (p, q)
  /// becomes the mean of the neighbours that hold it; where none does, Γ^{pr} + Γ^{rq} of the vertex itself, averaged
  /// over the regions r between (jumps of the potential add up); else 0. Call after the connectivity changed.
  void match(const lostopos::SurfaceMesh& mesh);

  /// Bytes of all values, on and off the heap.
  std::size_t memory_bytes() const;

 private:
  lostopos::VertexAttribute<VertexCirculation> values_;
};

/// Γ^{pq} at the three corners of t, for t's own labels (p, q).
std::array<double, 3> corner_circulation(const lostopos::SurfaceMesh& mesh, const CirculationField& circulation,
                                         lostopos::Triangle t);

}  // namespace foamsim
