#include "FoamSim/effects/blow.h"

#include <algorithm>

#include "Base/error.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Vertex;

void Blow::attach(lostopos::SurfaceMesh& mesh) {
  straw_.emplace(mesh.add_vertex_attribute<std::uint8_t>("straw", lostopos::carry::copy));
}

void Blow::begin(const EffectStep& step) {
  const std::vector<lostopos::Region> present = lostopos::regions(step.mesh);
  if (!std::ranges::binary_search(present, options_.region))
    throw base::InputError("blow_region " + std::to_string(options_.region.index()) +
                           " is none of this surface, whose regions go up to " +
                           std::to_string(present.back().index()));
  bool found = false;
  for (Vertex v : where_.of(step.mesh, step.held))
    if (step.is_held(v)) {
      (*straw_)[v] = 1;
      found = true;
    }
  if (!found)
    throw base::InputError("blow_where = '" + options_.where +
                           "' has no vertex that is held, and a straw is held; give a selection of held vertices");
}

std::span<const std::uint8_t> Blow::mouth(double time) const {
  if (!is_on(time)) return {};
  return straw_->slots();
}

void Blow::drive_circulation(const EffectStep& step, CirculationField& circulation) {
  for (Vertex v : step.mesh.vertices()) {
    if ((*straw_)[v] == 0 || !step.is_held(v)) continue;
    for (PairCirculation& entry : circulation.at(v)) {
      if (entry.pair.high == options_.region) entry.value -= options_.rate * step.dt;
      if (entry.pair.low == options_.region) entry.value += options_.rate * step.dt;
    }
  }
}

}  // namespace foamsim
