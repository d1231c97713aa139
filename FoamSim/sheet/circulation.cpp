#include "FoamSim/sheet/circulation.h"

#include <algorithm>
#include <boost/container/flat_map.hpp>
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

// Mean of Γ^{pr} + Γ^{rq} over the regions r for which both are held; 0 where there is none.
double sum_over_regions_between(const CirculationField::VertexValues& values, RegionPair pq) {
  double sum = 0;
  int ways = 0;
  for (const PairCirculation& held : values) {
    if ((held.pair.low == pq.low) == (held.pair.high == pq.low)) continue;
    const lostopos::Region between = held.pair.low == pq.low ? held.pair.high : held.pair.low;
    const auto rest = between == pq.high ? std::nullopt : value_of(values, RegionPair(between, pq.high));
    if (!rest) continue;
    sum += RegionPair::sign({pq.low, between}) * held.value + RegionPair::sign({between, pq.high}) * *rest;
    ++ways;
  }
  return ways > 0 ? sum / ways : 0.0;
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

CirculationField::VertexValues CirculationField::mean(const lostopos::Place& place) const {
  if (place.count == 1) return values_[place.vertices[0]];
  struct Sum {
    double value = 0, weight = 0;
  };
  boost::container::flat_map<RegionPair, Sum> sums;
  for (std::size_t i = 0; i < place.count; ++i)
    for (const PairCirculation& held : values_[place.vertices[i]]) {
      if (!(place.weights[i] > 0)) continue;
      Sum& sum = sums[held.pair];
      sum.value += place.weights[i] * held.value;
      sum.weight += place.weights[i];
    }
  VertexValues result;
  for (const auto& [pair, sum] : sums) result.push_back({pair, sum.value / sum.weight});
  return result;
}

void CirculationField::add_missing(const SurfaceMesh& mesh, Vertex v, const VertexValues& values) {
  const auto pairs = pairs_meeting_at(mesh, v);
  VertexValues& own = values_[v];
  for (const PairCirculation& given : values) {
    if (!std::ranges::binary_search(pairs, given.pair)) continue;
    if (const auto it = find(own, given.pair); it == own.end() || it->pair != given.pair) own.insert(it, given);
  }
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
      matched.push_back({pair, own ? *own : value_of_new_pair(mesh, v, pair)});
    }
    changed.emplace_back(v, std::move(matched));
  }
  for (auto& [v, values] : changed) values_[v] = std::move(values);
}

double CirculationField::value_of_new_pair(const SurfaceMesh& mesh, Vertex v, RegionPair pair) const {
  double sum = 0;
  int holders = 0;
  for (Edge e : mesh.edges(v))
    if (const auto near = value_of(values_[mesh.other_vertex(e, v)], pair)) {
      sum += *near;
      ++holders;
    }
  return holders > 0 ? sum / holders : sum_over_regions_between(values_[v], pair);
}

std::size_t CirculationField::memory_bytes() const {
  std::size_t bytes = values_.slots().size() * sizeof(VertexValues);
  for (const VertexValues& values : values_.slots())
    if (values.capacity() > VertexValues::static_capacity) bytes += values.capacity() * sizeof(PairCirculation);
  return bytes;
}

CirculationField::VertexValues interpolate(const CirculationField::VertexValues& a,
                                           const CirculationField::VertexValues& b, double t) {
  CirculationField::VertexValues mixed = a;
  for (PairCirculation& held : mixed)
    if (const auto other = value_of(b, held.pair)) held.value = (1 - t) * held.value + t * *other;
  for (const PairCirculation& held : b)
    if (const auto it = find(mixed, held.pair); it == mixed.end() || it->pair != held.pair) mixed.insert(it, held);
  return mixed;
}

std::array<double, 3> corner_circulation(const SurfaceMesh& mesh, const CirculationField& circulation, Triangle t) {
  const Labels pq = mesh.labels(t);
  const auto& v = mesh.vertices(t);
  return {circulation.get(v[0], pq), circulation.get(v[1], pq), circulation.get(v[2], pq)};
}

}  // namespace foamsim
