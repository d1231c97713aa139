#include "FoamSim/sheet/sheet_strength.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>

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
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sheet.size(), 512),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i)
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
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, sheet.size(), 512), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const auto& v = sheet[i].vertices;
          const std::array<Vec3, 3> x{positions[v[0].index()], positions[v[1].index()], positions[v[2].index()]};
          sources.set(i, (x[0] + x[1] + x[2]) / 3.0, sheet_strength(x, sheet[i].circulation));
        }
      });
}

}  // namespace foamsim
