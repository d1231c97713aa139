#include "FoamSim/sheet/pressure/vertex_area/registry.h"

#include <array>

#include "Base/names/nearest_name.h"
#include "FoamSim/sheet/pressure/vertex_area/averaged.h"
#include "FoamSim/sheet/pressure/vertex_area/border_length.h"
#include "FoamSim/sheet/pressure/vertex_area/constant_edge.h"
#include "FoamSim/sheet/pressure/vertex_area/naive.h"

namespace foamsim {
namespace {

using Options = const VertexAreaOptions&;
using Made = std::unique_ptr<VertexArea>;

constexpr std::array strategies{
    VertexAreaEntry{"naive", "each region by its own triangles; a double bubble drifts away",
                    [](Options) -> Made { return std::make_unique<NaiveArea>(); }},
    VertexAreaEntry{"constant-edge", "phi times mean edge times junction length; stable, wrong angles",
                    [](Options o) -> Made { return std::make_unique<ConstantEdgeArea>(o.phi, o.resolution); }},
    VertexAreaEntry{"averaged", "mean over the regions; stable, angles converge to 120 degrees",
                    [](Options) -> Made { return std::make_unique<AveragedArea>(); }},
    VertexAreaEntry{"border-length", "averaged, shared out by border length; balanced at Plateau vertices too",
                    [](Options) -> Made { return std::make_unique<BorderLengthArea>(); }},
};

}  // namespace

std::span<const VertexAreaEntry> vertex_area_strategies() {
  return strategies;
}

std::unique_ptr<VertexArea> make_vertex_area(std::string_view name, const VertexAreaOptions& options) {
  return base::find_by_name(vertex_area_strategies(), name, "area strategy").make(options);
}

}  // namespace foamsim
