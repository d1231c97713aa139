#include "FoamSim/sheet/circulation.h"

#include <algorithm>

#include "FoamSim/sheet/circulation_transfer.h"

namespace foamsim {

using lostopos::Labels;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

CirculationField::CirculationField(SurfaceMesh& mesh)
    : values_(mesh.add_vertex_attribute<VertexCirculation>("circulation", std::make_unique<CirculationTransfer>())) {
  const bool known = std::ranges::any_of(values_.slots(), [](const VertexCirculation& v) { return !v.empty(); });
  if (!known) match(mesh);
}

double CirculationField::get(Vertex v, Labels pq) const {
  const VertexCirculation& values = values_[v];
  const auto it = lower_bound(values, RegionPair(pq));
  return it != values.end() && it->pair == RegionPair(pq) ? RegionPair::sign(pq) * it->value
                                                          : RegionPair::sign(pq) * 0.0;
}

void CirculationField::set(Vertex v, Labels pq, double value) {
  const RegionPair pair(pq);
  const double stored = RegionPair::sign(pq) * value;
  VertexCirculation& values = values_[v];
  const auto it = lower_bound(values, pair);
  if (it != values.end() && it->pair == pair)
    it->value = stored;
  else
    values.insert(it, {pair, stored});
}

void CirculationField::match(const SurfaceMesh& mesh) {
  std::vector<Vertex> all;
  all.reserve(mesh.vertex_count());
  for (Vertex v : mesh.vertices()) all.push_back(v);
  foamsim::match(values_.slots(), mesh, all);
}

std::size_t CirculationField::memory_bytes() const {
  std::size_t bytes = values_.slots().size() * sizeof(VertexCirculation);
  for (const VertexCirculation& values : values_.slots())
    if (values.capacity() > VertexCirculation::static_capacity) bytes += values.capacity() * sizeof(PairCirculation);
  return bytes;
}

std::array<double, 3> corner_circulation(const SurfaceMesh& mesh, const CirculationField& circulation, Triangle t) {
  const Labels pq = mesh.labels(t);
  const auto& v = mesh.vertices(t);
  return {circulation.get(v[0], pq), circulation.get(v[1], pq), circulation.get(v[2], pq)};
}

}  // namespace foamsim
