#include "FoamSim/sheet/circulation_values.h"

#include <algorithm>
#include <boost/container/flat_map.hpp>
#include <cmath>
#include <optional>

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

namespace {

std::optional<double> value_of(const VertexCirculation& values, RegionPair pair) {
  const auto it = lower_bound(values, pair);
  return it != values.end() && it->pair == pair ? std::optional(it->value) : std::nullopt;
}

// Mean of Γ^{pr} + Γ^{rq} over the regions r for which both are held; 0 where there is none.
double sum_over_regions_between(const VertexCirculation& values, RegionPair pq) {
  double sum = 0;
  int ways = 0;
  for (const PairCirculation& entry : values) {
    if ((entry.pair.low == pq.low) == (entry.pair.high == pq.low)) continue;
    const lostopos::Region between = entry.pair.low == pq.low ? entry.pair.high : entry.pair.low;
    const auto rest = between == pq.high ? std::nullopt : value_of(values, RegionPair(between, pq.high));
    if (!rest) continue;
    sum += RegionPair::sign({pq.low, between}) * entry.value + RegionPair::sign({between, pq.high}) * *rest;
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

double value_of_new_pair(std::span<const VertexCirculation> values, const SurfaceMesh& mesh, Vertex v,
                         RegionPair pair) {
  double sum = 0;
  int holders = 0;
  for (Edge e : mesh.edges(v))
    if (const auto near = value_of(values[mesh.other_vertex(e, v).index()], pair)) {
      sum += *near;
      ++holders;
    }
  return holders > 0 ? sum / holders : sum_over_regions_between(values[v.index()], pair);
}

}  // namespace

bool is_sound(const VertexCirculation& values) {
  const auto is_none = [](const PairCirculation& entry) {
    return entry.pair.low == entry.pair.high || !entry.pair.high.valid() || !std::isfinite(entry.value);
  };
  return std::ranges::none_of(values, is_none) &&
         std::ranges::adjacent_find(values, std::ranges::greater_equal(), &PairCirculation::pair) == values.end();
}

bool matches(std::span<const PairCirculation> values, const SurfaceMesh& mesh, Vertex v) {
  return std::ranges::equal(pairs_meeting_at(mesh, v), values, {}, {}, &PairCirculation::pair);
}

VertexCirculation interpolate(const VertexCirculation& a, const VertexCirculation& b, double t) {
  VertexCirculation mixed = a;
  for (PairCirculation& entry : mixed)
    if (const auto other = value_of(b, entry.pair)) entry.value = (1 - t) * entry.value + t * *other;
  for (const PairCirculation& entry : b)
    if (const auto it = lower_bound(mixed, entry.pair); it == mixed.end() || it->pair != entry.pair)
      mixed.insert(it, entry);
  return mixed;
}

VertexCirculation mean(std::span<const VertexCirculation> values, const lostopos::Place& place) {
  if (place.count == 1) return values[place.vertices[0].index()];
  struct Sum {
    double value = 0, weight = 0;
  };
  boost::container::flat_map<RegionPair, Sum> sums;
  for (std::size_t i = 0; i < place.count; ++i)
    for (const PairCirculation& entry : values[place.vertices[i].index()]) {
      if (!(place.weights[i] > 0)) continue;
      Sum& sum = sums[entry.pair];
      sum.value += place.weights[i] * entry.value;
      sum.weight += place.weights[i];
    }
  VertexCirculation result;
  for (const auto& [pair, sum] : sums) result.push_back({pair, sum.value / sum.weight});
  return result;
}

void add_missing(std::span<VertexCirculation> values, const SurfaceMesh& mesh, Vertex v,
                 const VertexCirculation& given) {
  const auto pairs = pairs_meeting_at(mesh, v);
  VertexCirculation& own = values[v.index()];
  for (const PairCirculation& entry : given) {
    if (!std::ranges::binary_search(pairs, entry.pair)) continue;
    if (const auto it = lower_bound(own, entry.pair); it == own.end() || it->pair != entry.pair) own.insert(it, entry);
  }
}

void match(std::span<VertexCirculation> values, const SurfaceMesh& mesh, std::span<const Vertex> vertices) {
  // Two passes, so that a mean over neighbours never depends on the order in which vertices are visited.
  boost::container::small_vector<std::pair<Vertex, VertexCirculation>, 4> changed;
  for (Vertex v : vertices) {
    const auto pairs = pairs_meeting_at(mesh, v);
    if (std::ranges::equal(pairs, values[v.index()], {}, {}, &PairCirculation::pair)) continue;
    VertexCirculation matched;
    for (RegionPair pair : pairs) {
      const auto own = value_of(values[v.index()], pair);
      matched.push_back({pair, own ? *own : value_of_new_pair(values, mesh, v, pair)});
    }
    changed.emplace_back(v, std::move(matched));
  }
  for (auto& [v, matched] : changed) values[v.index()] = std::move(matched);
}

}  // namespace foamsim

namespace lostopos {

namespace {

struct StoredPair {
  std::uint32_t low, high;
  double value;
};

using CirculationCodec = ListCodec<foamsim::VertexCirculation, StoredPair>;

}  // namespace

void AttributeCodec<foamsim::VertexCirculation>::encode(std::span<const foamsim::VertexCirculation> values,
                                                        std::vector<std::uint8_t>& bytes) {
  CirculationCodec::encode(values, bytes, [](const foamsim::PairCirculation& own) {
    return StoredPair{own.pair.low.index(), own.pair.high.index(), own.value};
  });
}

std::optional<std::vector<foamsim::VertexCirculation>> AttributeCodec<foamsim::VertexCirculation>::decode(
    std::span<const std::uint8_t> bytes) {
  auto values = CirculationCodec::decode(bytes, [](const StoredPair& stored) {
    return foamsim::PairCirculation{foamsim::RegionPair(Region(stored.low), Region(stored.high)), stored.value};
  });
  if (!values || !std::ranges::all_of(*values, [](const auto& own) { return foamsim::is_sound(own); })) return {};
  return values;
}

}  // namespace lostopos
