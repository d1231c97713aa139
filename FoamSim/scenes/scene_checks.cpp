// Whether the options of a scene go together.

#include <algorithm>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"

namespace foamsim {
namespace {

// Whether the scene uses the owner of an option.
bool uses(const base::OptionSet& options, const base::OptionSpec::Owner& owner,
          std::span<const std::string> also_used) {
  const auto& [kind, name] = owner;
  const bool vortex_sheet = options.word("dynamics") == "vortex-sheet";
  const bool presses =
      (vortex_sheet ? !takes_tension(options.word("integrator")) : options.word("forces") == "pressure-scheme") &&
      names_have(effects_of(options), "surface_tension");
  if (names_have(also_used, name)) return true;
  if (kind == "effect") return names_have(effects_of(options), name);
  if (kind == "dynamics") return options.word("dynamics") == name;
  if (kind == "constraint") return names_have(options.words("constraints"), name);
  if (kind == "velocity sum")
    return options.word("velocity") == name || (options.word("velocity") == "auto" && name == "tree");
  if (kind == "integrator") return vortex_sheet && options.word("integrator") == name;
  if (kind == "forces") return presses;
  if (kind == "pressure scheme") return presses && options.word("pressure") == name;
  if (kind == "area strategy")
    return uses(options, {"pressure scheme", "edge_angle"}, also_used) && options.word("area") == name;
  return true;
}

// What the conservative dynamics cannot have, and why.
void refuse_for_conservative(const base::OptionSet& options) {
  if (options.word("dynamics") != "conservative") return;
  if (names_have(effects_of(options), "diffusion"))
    throw base::InputError(
        "effect 'diffusion' smooths circulation pair by pair, which can win energy, and is not for "
        "dynamics=conservative; "
        "use --set viscosity=ETA (surface viscosity, L^3/T) in its place");
  if (options.is_set("precision") && options.word("velocity") == "tree")
    throw base::InputError("option 'precision' is for direct sums; velocity=tree has --set tolerance=...");
  const double delta = options.number("delta"), resolution = options.number("resolution");
  if (delta > 0 && resolution > 0 && delta < 0.1 * resolution)
    throw base::InputError(
        "delta is below a tenth of the resolution, where slivers make the kinetic energy of "
        "dynamics=conservative as good as singular; leave it out (half the resolution) or give at "
        "least " +
        base::to_text(0.1 * resolution));
}

// Effects of which nothing is left without air.
void refuse_for_relaxation(const base::OptionSet& options) {
  if (options.word("dynamics") != "relaxation") return;
  for (const char* effect : {"diffusion", "damping", "blow"})
    if (names_have(effects_of(options), effect))
      throw base::InputError("effect '" + std::string(effect) +
                             "' acts on the air, and dynamics=relaxation has none; leave it out of --set effects=...");
  for (const char* air : {"velocity", "air_by_stage"})
    if (options.is_set(air))
      throw base::InputError("option '" + std::string(air) + "' is about the air, and dynamics=relaxation has none");
}

// What is read by some of its steppings only.
void refuse_for_stepping(const base::OptionSet& options) {
  if (options.word("dynamics") != "conservative" || options.word("stepping") == "kick-drift") return;
  if (options.is_set("correction") && options.flag("correction"))
    throw base::InputError("option 'correction' is for stepping=kick-drift; stepping=" + options.word("stepping") +
                           " keeps energy by its order alone");
}

// Of an option whose owner the scene does not use.
std::string not_used_message(const base::OptionSpec& spec, const base::OptionSet& options) {
  const auto& [kind, name] = spec.owner;
  std::string help;
  if (kind == "pressure scheme" && takes_tension(options.word("integrator")))
    help = "; integrator=" + options.word("integrator") + " has its own curvature and areas";
  else if (kind == "effect")
    help = "; add it with --set effects+=" + name;
  else if (options.word("dynamics") == "conservative" && spec.key == "integrator")
    help = "; dynamics=conservative has --set stepping=kick-drift, midpoint or rk4";
  else if (options.word("dynamics") == "conservative")
    help =
        "; dynamics=conservative has exact forces and the velocities that belong to them (but for --set "
        "forces=pressure-scheme, --set velocities=sheet)";
  return "option '" + spec.key + "' belongs to the " + kind + " '" + name + "', which this scene does not use" + help;
}

}  // namespace

void validate(const Scene& scene, std::span<const std::string> also_used) {
  refuse_for_conservative(scene.options);
  refuse_for_stepping(scene.options);
  refuse_for_relaxation(scene.options);
  if (scene.options.number("dt") == 0 && scene.options.word("dynamics") == "vortex-sheet")
    throw base::InputError(
        "dt=auto is for dynamics=conservative, whose longest stable step is known; with dynamics=vortex-sheet give dt "
        "as a number: 0.9 h^1.5 / sqrt(sigma) for edges of a length h is near what it bears");
  for (const base::OptionSpec& spec : scene.options.specs()) {
    const auto& [kind, name] = spec.owner;
    if (kind.empty() || !scene.options.is_set(spec.key) || uses(scene.options, spec.owner, also_used)) continue;
    throw base::InputError(not_used_message(spec, scene.options));
  }
}

}  // namespace foamsim
