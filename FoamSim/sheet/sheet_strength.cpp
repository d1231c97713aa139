#include "FoamSim/sheet/sheet_strength.h"

#include <Eigen/Geometry>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

using lostopos::Triangle;
using lostopos::Vec3;

void gather_sheet(const lostopos::SurfaceMesh& mesh, const CirculationField& circulation,
                  std::vector<SheetTriangle>& sheet, std::span<const std::uint8_t> solid) {
  sheet.clear();
  sheet.reserve(mesh.triangle_count());
  for (Triangle t : mesh.triangles())
    if (!is_solid(t, solid)) sheet.push_back({t, mesh.vertices(t), {}});
  base::parallel_for_each(sheet.size(), 512, [&](std::size_t i) {
    sheet[i].circulation = corner_circulation(mesh, circulation, sheet[i].triangle);
  });
}

Vec3 sheet_strength(const std::array<Vec3, 3>& x, const std::array<double, 3>& circulation) {
  const auto& [a, b, c] = x;
  return -((b - a) * circulation[2] + (c - b) * circulation[0] + (a - c) * circulation[1]);
}

void fill_vortex_sources(std::span<const SheetTriangle> sheet, std::span<const Vec3> positions,
                         VortexSources& sources) {
  sources.resize(sheet.size());
  base::parallel_for_each(sheet.size(), 512, [&](std::size_t i) {
    const auto& v = sheet[i].vertices;
    const std::array<Vec3, 3> x{positions[v[0].index()], positions[v[1].index()], positions[v[2].index()]};
    sources.set(i, (x[0] + x[1] + x[2]) / 3.0, sheet_strength(x, sheet[i].circulation));
  });
}

}  // namespace foamsim
