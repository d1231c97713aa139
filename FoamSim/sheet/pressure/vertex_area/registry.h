#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

namespace foamsim {

struct VertexAreaOptions {
  double phi = 0.5;       ///< constant-edge's φ, dimensionless, > 0
  double resolution = 0;  ///< h̄ (L); 0: the mean over the mesh's edges at the time
};

/// An area strategy as users know it.
struct VertexAreaEntry {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<VertexArea> (*make)(const VertexAreaOptions&);
};

/// All strategies. A new one is a file beside this and a line in the table.
std::span<const VertexAreaEntry> vertex_area_strategies();

/// Throws base::InputError that names the strategies there are.
std::unique_ptr<VertexArea> make_vertex_area(std::string_view name, const VertexAreaOptions& options);

}  // namespace foamsim
