#include "FoamSim/scenes/methods.h"

#include <algorithm>

namespace foamsim {

std::vector<std::string> method_names(const Catalogue& catalogue) {
  std::vector<std::string> names = catalogue.sheet.areas.names();
  names.emplace_back(conservative_method);
  return names;
}

void require_method(const Catalogue& catalogue, const std::string& method) {
  if (method != conservative_method) catalogue.sheet.areas.find(method);
}

void choose_method(base::OptionSet& options, const std::string& method, const std::string& where) {
  if (method != conservative_method) {
    options.set("dynamics", std::string("vortex-sheet"), where);
    options.set("area", method, where);
    for (const base::OptionSpec& spec : std::vector(options.specs()))
      if (spec.owner.kind == "area strategy" && spec.owner.name != method) options.unset(spec.key);
    return;
  }
  options.set("dynamics", std::string("conservative"), where);
  std::vector<std::string> effects = options.words("effects");
  // Of what smooths circulation, viscosity in about that strength.
  if (std::erase(effects, "diffusion") > 0) options.set("viscosity", 0.1, where);
  if (std::ranges::find(effects, "volumes") == effects.end()) effects.emplace_back("volumes");
  options.set("effects", effects, where);
  // What belongs to models that are not used now.
  for (const base::OptionSpec& spec : std::vector(options.specs()))
    if (const std::string& kind = spec.owner.kind; kind == "pressure scheme" || kind == "area strategy" ||
                                                   kind == "forces" || kind == "integrator" ||
                                                   (kind == "dynamics" && spec.owner.name == "vortex-sheet") ||
                                                   (kind == "effect" && spec.owner.name == "diffusion"))
      options.unset(spec.key);
}

std::vector<std::string> also_used_by(const std::vector<std::string>& methods) {
  std::vector<std::string> used = methods;
  used.insert(used.end(), {"vortex-sheet", "sheet", "pressure-scheme", "edge_angle", "diffusion"});
  return used;
}

}  // namespace foamsim
