#include "FoamSim/sheet/burst_transfer.h"

#include <algorithm>
#include <map>
#include <optional>

namespace foamsim {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

struct Difference {
  double sum = 0;
  std::size_t count = 0;
  double half() const { return count == 0 ? 0 : sum / static_cast<double>(2 * count); }
};

// Γ^{pq} at v; nothing where v has no film between them.
std::optional<double> held_value(const CirculationField& circulation, Vertex v, Region p, Region q) {
  const auto values = circulation.at(v);
  const auto it = std::ranges::lower_bound(values, RegionPair(p, q), {}, &PairCirculation::pair);
  if (it == values.end() || it->pair != RegionPair(p, q)) return {};
  return RegionPair::sign({p, q}) * it->value;
}

void join_at(Vertex v, Region bursting, Region other, double half, CirculationField& circulation) {
  const std::optional<double> outside = held_value(circulation, v, air, other);
  const std::optional<double> inside = held_value(circulation, v, bursting, other);
  if (!outside && !inside) return;
  double joined = 0;
  if (outside && inside)
    joined = (*outside + *inside) / 2;
  else
    joined = outside ? *outside - half : *inside + half;
  circulation.set(v, {air, other}, joined);
  if (inside) circulation.set(v, {bursting, other}, 0);
}

}  // namespace

void join_circulation_to_air(const SurfaceMesh& mesh, Region bursting, CirculationField& circulation) {
  std::map<Region, Difference> neighbours;
  for (lostopos::Triangle t : mesh.triangles()) {
    const lostopos::Labels labels = mesh.labels(t);
    if (labels.has(bursting) && !labels.has(air)) neighbours[labels.p == bursting ? labels.q : labels.p];
  }
  for (auto& [other, difference] : neighbours)
    for (Vertex v : mesh.vertices()) {
      const auto outside = held_value(circulation, v, air, other), inside = held_value(circulation, v, bursting, other);
      if (!outside || !inside) continue;
      difference.sum += *outside - *inside;
      ++difference.count;
    }
  for (const auto& [other, difference] : neighbours)
    for (Vertex v : mesh.vertices()) join_at(v, bursting, other, difference.half(), circulation);
}

}  // namespace foamsim
