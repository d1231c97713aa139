#include "FoamSim/studies/reproduce/stretched_junction.h"

#include <algorithm>

#include "Base/io/atomic_file.h"
#include "Base/options/option_value.h"
#include "FoamSim/sheet/pressure/curvature.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "FoamSim/studies/reproduce/report_scene.h"
#include "LosTopos/shapes/triple_junction.h"

namespace foamsim {
namespace {

constexpr int stretched_film = 1;  // between regions 1 and 2

std::array<double, 3> curvatures(std::string_view area, double stretch) {
  const lostopos::TripleJunction junction = lostopos::triple_junction({120, 120, 120}, stretched_film, stretch);
  SurfaceGeometry geometry;
  geometry.update(junction.mesh);
  CurvatureField field;
  field.update(junction.mesh, geometry, EdgeAngleCurvature(make_vertex_area(area, {.phi = 0.5, .resolution = 1})));
  const auto h = field.at(geometry, junction.border[junction.border.size() / 2]);
  return {h[0], h[1], h[2]};
}

}  // namespace

double StretchedJunctionRow::imbalance() const {
  const auto [low, high] = std::ranges::minmax(curvature);
  return high - low;
}

std::vector<StretchedJunctionRow> stretch_junction(const std::vector<double>& stretches) {
  std::vector<StretchedJunctionRow> rows;
  for (const char* area : report_areas)
    for (double stretch : stretches) rows.push_back({area, stretch, curvatures(area, stretch)});
  return rows;
}

void write_stretched_junction(const std::filesystem::path& file, const std::vector<StretchedJunctionRow>& rows) {
  base::AtomicFile out(file);
  out.stream() << "area,stretch,region,curvature,imbalance\n";
  for (const StretchedJunctionRow& row : rows)
    for (std::size_t region = 0; region < 3; ++region)
      out.stream() << row.area << ',' << base::to_text(row.stretch) << ',' << region << ','
                   << base::to_text(row.curvature[region]) << ',' << base::to_text(row.imbalance()) << '\n';
  out.commit();
}

}  // namespace foamsim
