#include "FoamSim/effects/diffusion.h"

#include <algorithm>
#include <map>

#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

void subtract_pair_means(const SurfaceMesh& mesh, CirculationField& circulation) {
  struct Sum {
    double value = 0;
    std::size_t count = 0;
  };
  std::map<RegionPair, Sum> sums;
  for (Vertex v : mesh.vertices())
    for (const PairCirculation& held : circulation.at(v)) {
      Sum& sum = sums[held.pair];
      sum.value += held.value;
      ++sum.count;
    }
  for (auto& [pair, sum] : sums) sum.value /= static_cast<double>(sum.count);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value -= sums[held.pair].value;
}

double smoothed_value(const SurfaceMesh& mesh, const CirculationField& circulation, Vertex v,
                      const PairCirculation& held, double fraction) {
  double sum = 0;
  int neighbours = 0;
  for (Edge e : mesh.edges(v)) {
    const auto near = circulation.at(mesh.other_vertex(e, v));
    const auto it = std::ranges::lower_bound(near, held.pair, {}, &PairCirculation::pair);
    if (it == near.end() || it->pair != held.pair) continue;
    sum += it->value;
    ++neighbours;
  }
  return neighbours == 0 ? held.value : held.value + fraction * (sum / neighbours - held.value);
}

}  // namespace

void Diffusion::update_circulation(const EffectStep& step, CirculationField& circulation) {
  if (rate_ == 0) return;
  subtract_pair_means(step.mesh, circulation);
  const double fraction = std::min(rate_ * step.dt, 1.0);
  begin_.assign(step.mesh.vertex_slots() + 1, 0);
  for (std::size_t i = 0; i < step.mesh.vertex_slots(); ++i)
    begin_[i + 1] = begin_[i] + (step.mesh.alive(Vertex(i)) ? circulation.at(Vertex(i)).size() : 0);
  smoothed_.resize(begin_.back());
  auto for_all_values = [&](auto&& body) {
    lostopos::for_each_vertex(step.mesh, [&](Vertex v) {
      for (std::size_t k = begin_[v.index()]; k != begin_[v.index() + 1]; ++k)
        body(v, circulation.at(v)[k - begin_[v.index()]], smoothed_[k]);
    });
  };
  for_all_values([&](Vertex v, PairCirculation& held, double& smoothed) {
    smoothed = smoothed_value(step.mesh, circulation, v, held, fraction);
  });
  for_all_values([](Vertex, PairCirculation& held, double smoothed) { held.value = smoothed; });
}

}  // namespace foamsim
