#pragma once

#include <memory>
#include <string_view>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

/// What an area strategy may be made from.
struct VertexAreaSetup {
  const base::OptionSet& options;  ///< with the strategy's own
  double resolution;               ///< h̄ (L); 0: the mean over the mesh's edges at the time
};
using VertexAreaEntry = base::Model<VertexArea, VertexAreaSetup>;

/// The built-in strategies. A new one is a file beside this and an entry here, or an entry that a program adds to its
/// own catalogue.
const base::Registry<VertexAreaEntry>& vertex_area_strategies();

struct VertexAreaOptions {
  double phi = 0.5;       ///< constant-edge's φ, dimensionless, > 0
  double resolution = 0;  ///< as above
};
/// A built-in strategy by itself. Throws base::InputError that names the strategies there are.
std::unique_ptr<VertexArea> make_vertex_area(std::string_view name, const VertexAreaOptions& options);

}  // namespace foamsim
