#include "FoamSim/dynamics/registry.h"

#include "FoamSim/dynamics/conservative.h"
#include "FoamSim/dynamics/vortex_sheet.h"

namespace foamsim {
namespace {

using Made = std::unique_ptr<Dynamics>;

struct SteppingName {
  const char* name;
  Stepping stepping;
};
constexpr SteppingName steppings[] = {
    {"kick-drift", Stepping::kick_drift}, {"midpoint", Stepping::midpoint}, {"rk4", Stepping::rk4}};

Stepping stepping_of(const std::string& name) {
  for (const SteppingName& entry : steppings)
    if (name == entry.name) return entry.stepping;
  return Stepping::kick_drift;
}

std::vector<base::OptionSpec> conservative_options() {
  std::vector<std::string> names;
  for (const SteppingName& entry : steppings) names.emplace_back(entry.name);
  return {
      base::word_from("stepping", std::string("kick-drift"), "how circulation and positions are advanced", "stepping",
                      names),
      base::non_negative_number("viscosity", 0, "surface viscosity of the films over air density, L^3/T"),
      base::whole_number("most_substeps", 16, 1, "parts that a step is made in where the stiffest vertex asks for it"),
      base::flag("near_field", true, "put back at short distances what the regularisation takes"),
      base::flag("inertia", true, "the force that keeps kinetic energy while the mesh moves"),
      base::flag("tangential", true, "the mesh goes along the films with the air; else along their normals only"),
      base::flag("correction", true, "what energy and impulse are still lost or won is given back"),
      base::flag("conserving_transfers", true, "remeshing keeps the integral of circulation over films")};
}

Made make_conservative(const DynamicsSetup& setup) {
  const base::OptionSet& options = setup.options;
  ConservativeOptions own;
  own.stepping = stepping_of(options.word("stepping"));
  own.near_field = options.flag("near_field");
  own.inertia = options.flag("inertia");
  own.tangential = options.flag("tangential");
  own.conserving_transfers = options.flag("conserving_transfers");
  own.correction = options.flag("correction");
  own.viscosity = options.number("viscosity");
  own.most_substeps = options.whole("most_substeps");
  return std::make_unique<Conservative>(own);
}

}  // namespace

const base::Registry<DynamicsEntry>& dynamics_schemes() {
  static const base::Registry<DynamicsEntry> entries(
      "dynamics",
      {{"vortex-sheet",
        "the vortex sheet of Da et al. 2015: pressure schemes drive circulation, Biot-Savart velocities move the films",
        {},
        [](const DynamicsSetup& setup) -> Made {
          return std::make_unique<VortexSheet>(
              setup.sheet.velocities.find(setup.options.word("velocity")).make({setup.options}),
              setup.integrators.find(setup.options.word("integrator")).make({setup.options}));
        }},
       {"conservative", "films as a mechanical system: energy, volumes and equilibria right by construction",
        conservative_options(), make_conservative}});
  return entries;
}

}  // namespace foamsim
