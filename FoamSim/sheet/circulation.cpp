#include "FoamSim/sheet/circulation.h"

#include <algorithm>
#include <optional>

namespace foamsim {

using lostopos::Edge;
using lostopos::Labels;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

namespace {

template <class Values>
auto find(Values& values, RegionPair pair) {
  return std::ranges::lower_bound(values, pair, {}, &PairCirculation::pair);
}

std::optional<double> value_of(const CirculationField::VertexValues& values, RegionPair pair) {
  const auto it = find(values, pair);
  return it != values.end() && it->pair == pair ? std::optional(it->value) : std::nullopt;
}

boost::container::small_vector<RegionPair, 8> pairs_meeting_at(const SurfaceMesh& mesh, Vertex v) {
  boost::container::small_vector<RegionPair, 8> pairs;
  for (Triangle t : mesh.triangles(v)) {
    const RegionPair pair(mesh.labels(t));
    const auto it = std::ranges::lower_bound(pairs, pair);
    if (it == pairs.end() || *it != pair) pairs.insert(it, pair);
  }
  return pairs;
}

}  // namespace

CirculationField::CirculationField(SurfaceMesh& mesh) : values_(mesh.add_vertex_attribute<VertexValues>()) {
  for (Vertex v : mesh.vertices())
    for (RegionPair pair : pairs_meeting_at(mesh, v)) values_[v].push_back({pair, 0.0});
}

double CirculationField::get(Vertex v, Labels pq) const {
  return RegionPair::sign(pq) * value_of(values_[v], RegionPair(pq)).value_or(0.0);
}

void CirculationField::set(Vertex v, Labels pq, double value) {
  const RegionPair pair(pq);
  const double stored = RegionPair::sign(pq) * value;
  VertexValues& values = values_[v];
  const auto it = find(values, pair);
  if (it != values.end() && it->pair == pair)
    it->value = stored;
  else
    values.insert(it, {pair, stored});
}

void CirculationField::interpolate(Vertex into, Vertex a, Vertex b, double t) {
  VertexValues mixed = values_[a];
  for (PairCirculation& held : mixed)
    if (const auto other = value_of(values_[b], held.pair)) held.value = (1 - t) * held.value + t * *other;
  for (const PairCirculation& held : values_[b])
    if (const auto it = find(mixed, held.pair); it == mixed.end() || it->pair != held.pair) mixed.insert(it, held);
  values_[into] = std::move(mixed);
}

void CirculationField::match(const SurfaceMesh& mesh) {
  std::vector<Vertex> all;
  all.reserve(mesh.vertex_count());
  for (Vertex v : mesh.vertices()) all.push_back(v);
  match(mesh, all);
}

void CirculationField::match(const SurfaceMesh& mesh, std::span<const Vertex> vertices) {
  // Two passes, so that a mean over neighbours never depends on the order in which vertices are visited.
  boost::container::small_vector<std::pair<Vertex, VertexValues>, 4> changed;
  for (Vertex v : vertices) {
    const auto pairs = pairs_meeting_at(mesh, v);
    if (std::ranges::equal(pairs, values_[v], {}, {}, &PairCirculation::pair)) continue;
    VertexValues matched;
    for (RegionPair pair : pairs) {
      const auto own = value_of(values_[v], pair);
      matched.push_back({pair, own ? *own : mean_of_neighbours(mesh, v, pair)});
    }
    changed.emplace_back(v, std::move(matched));
  }
  for (auto& [v, values] : changed) values_[v] = std::move(values);
}

double CirculationField::mean_of_neighbours(const SurfaceMesh& mesh, Vertex v, RegionPair pair) const {
  double sum = 0;
  int holders = 0;
  for (Edge e : mesh.edges(v))
    if (const auto near = value_of(values_[mesh.other_vertex(e, v)], pair)) {
      sum += *near;
      ++holders;
    }
  return holders > 0 ? sum / holders : 0.0;
}

std::size_t CirculationField::memory_bytes() const {
  std::size_t bytes = values_.slots().size() * sizeof(VertexValues);
  for (const VertexValues& values : values_.slots())
    if (values.capacity() > VertexValues::static_capacity) bytes += values.capacity() * sizeof(PairCirculation);
  return bytes;
}

std::array<double, 3> corner_circulation(const SurfaceMesh& mesh, const CirculationField& circulation, Triangle t) {
  const Labels pq = mesh.labels(t);
  const auto& v = mesh.vertices(t);
  return {circulation.get(v[0], pq), circulation.get(v[1], pq), circulation.get(v[2], pq)};
}

}  // namespace foamsim
