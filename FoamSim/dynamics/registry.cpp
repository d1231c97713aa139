#include "FoamSim/dynamics/registry.h"

#include <algorithm>
#include <array>

#include "FoamSim/dynamics/conservative.h"
#include "FoamSim/dynamics/relaxation.h"
#include "FoamSim/dynamics/vortex_sheet.h"

namespace foamsim {
namespace {

using Made = std::unique_ptr<Dynamics>;

template <class Choice>
struct Named {
  const char* name;
  Choice choice;
};
constexpr std::array steppings{Named<Stepping>{"kick-drift", Stepping::kick_drift},
                               Named<Stepping>{"midpoint", Stepping::midpoint}, Named<Stepping>{"rk4", Stepping::rk4}};
constexpr std::array tangentials{Named<Tangential>{"none", Tangential::none}, Named<Tangential>{"air", Tangential::air},
                                 Named<Tangential>{"smoothed", Tangential::smoothed}};
constexpr std::array precisions{Named<Precision>{"auto", Precision::automatic},
                                Named<Precision>{"double", Precision::doubles},
                                Named<Precision>{"single", Precision::singles}};

template <class Choice, std::size_t n>
std::vector<std::string> names_of(const std::array<Named<Choice>, n>& choices) {
  std::vector<std::string> names;
  names.reserve(n);
  for (const auto& entry : choices) names.emplace_back(entry.name);
  return names;
}

// Of the words that the specification allows.
template <class Choice, std::size_t n>
Choice choice_of(const std::array<Named<Choice>, n>& choices, const std::string& name) {
  return std::ranges::find(choices, name, &Named<Choice>::name)->choice;
}

std::vector<base::OptionSpec> conservative_options() {
  return {
      base::word_from("forces", std::string("gradient"), "of tension: the energy's gradient, or a pressure scheme",
                      "forces", {"gradient", "pressure-scheme"}),
      base::word_from("velocities", std::string("adjoint"),
                      "of the mesh: those that belong to the forces, or section "
                      "3's sum",
                      "velocities", {"adjoint", "sheet"}),
      base::word_from("stepping", std::string("kick-drift"), "how circulation and positions are advanced", "stepping",
                      names_of(steppings)),
      base::non_negative_number("viscosity", 0, "surface viscosity of the films over air density, L^3/T"),
      base::whole_number("most_substeps", 16, 1, "parts that a step is made in where stiff or fast films ask for it"),
      base::positive_number("safety", 0.75, "such a part is at most this share of what the stiffest films bear"),
      base::positive_number("largest_strain", 0.4, "nor does an edge change by more in it, as a share of its length"),
      base::flag("near_field", true, "put back at short distances what the regularisation takes"),
      base::flag("inertia", true, "the force that keeps kinetic energy while the mesh moves"),
      base::word_from("tangential", std::string("smoothed"), "how the mesh goes along the films", "tangential motion",
                      names_of(tangentials)),
      base::word_from("precision", std::string("auto"),
                      "of direct sums over pairs of triangles; auto: single from " + std::to_string(many_triangles) +
                          " triangles on",
                      "precision", names_of(precisions)),
      base::flag("correction", true, "what energy and impulse are still lost or won is given back"),
      base::flag("conserving_transfers", true, "remeshing keeps the integral of circulation over films")};
}

Made make_conservative(const DynamicsSetup& setup) {
  const base::OptionSet& options = setup.options;
  ConservativeOptions own;
  own.stepping = choice_of(steppings, options.word("stepping"));
  own.near_field = options.flag("near_field");
  own.inertia = options.flag("inertia");
  own.tangential = choice_of(tangentials, options.word("tangential"));
  own.precision = choice_of(precisions, options.word("precision"));
  own.conserving_transfers = options.flag("conserving_transfers");
  own.correction = options.flag("correction");
  own.viscosity = options.number("viscosity");
  own.safety = options.number("safety");
  own.largest_strain = options.number("largest_strain");
  own.most_substeps = options.whole("most_substeps");
  own.sheet_velocities = options.word("velocities") == "sheet";
  return std::make_unique<Conservative>(
      own, setup.sheet.velocities.find(options.word("velocity")).make({options, setup.sheet.ranks}));
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
              setup.sheet.velocities.find(setup.options.word("velocity")).make({setup.options, setup.sheet.ranks}),
              setup.integrators.find(setup.options.word("integrator")).make({setup.options}));
        }},
       {"conservative", "films as a mechanical system: energy, volumes and equilibria right by construction",
        conservative_options(), make_conservative},
       {"relaxation",
        "films without air go down the gradient of their energy to equilibrium; time has no meaning",
        {},
        [](const DynamicsSetup&) -> Made { return std::make_unique<Relaxation>(); }}});
  return entries;
}

}  // namespace foamsim
