#pragma once

#include <span>
#include <string>
#include <vector>

#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/sheet/velocity/biot_savart.h"
#include "LosTopos/io/surface_data.h"

namespace foamsim {

/// The word that stands for all fields.
inline constexpr const char* all_fields = "all";

/// What a picture of the simulation can have: the fields of films (docs/output.md "Fields for ParaView") and every
/// named attribute that is a number.
std::vector<std::string> picture_field_names(const Simulation& simulation);

/// Throws base::InputError, with what there is, for a name that is neither one of these nor `all_fields`.
void require_picture_fields(const Simulation& simulation, std::span<const std::string> names);

/// What pictures are made from besides the simulation.
struct PictureSetup {
  std::span<const std::string> fields;  ///< by name, or all_fields
  double sigma;                         ///< tension of one film side over density, L³/T²
  const BiotSavart& velocity;           ///< sums the velocity, where it is wanted
};

/// The surface with the fields, every film oriented with its lower region behind, and the Plateau borders as lines.
/// Throws what `require_picture_fields` throws.
lostopos::SurfaceData picture_of(const Simulation& simulation, const PictureSetup& setup);

}  // namespace foamsim
