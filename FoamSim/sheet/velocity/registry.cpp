#include "FoamSim/sheet/velocity/registry.h"

#include "FoamSim/sheet/velocity/direct.h"

namespace foamsim {

const base::Registry<VelocityEntry>& velocity_sums() {
  static const base::Registry<VelocityEntry> sums(
      "velocity sum",
      {{"direct",
        "every source for every target, exact to rounding; cost grows with the square of the triangles",
        {},
        [](const VelocitySetup&) -> std::unique_ptr<BiotSavart> { return std::make_unique<DirectBiotSavart>(); }}});
  return sums;
}

std::unique_ptr<BiotSavart> make_biot_savart(std::string_view name) {
  const VelocityEntry& entry = velocity_sums().find(name);
  const base::OptionSet own(entry.options);
  return entry.make({own});
}

}  // namespace foamsim
