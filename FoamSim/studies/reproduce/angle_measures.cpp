#include "FoamSim/studies/reproduce/angle_measures.h"

#include <cmath>

#include "Base/io/atomic_file.h"
#include "Base/options/option_value.h"
#include "FoamSim/metrics/film_angles.h"
#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/studies/reproduce/report_scene.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

std::vector<MeasuredExactly> measure_exact_double_bubbles() {
  std::vector<MeasuredExactly> rows;
  for (double ratio : {1.0, 2.0}) {
    const DoubleBubbleEquilibrium equilibrium = double_bubble_equilibrium(1, ratio);
    for (long segments : report_subdivisions) {
      const lostopos::SurfaceMesh mesh = exact_double_bubble(equilibrium, segments);
      const JunctionAngles facets = junction_angles(mesh);
      const FilmAngles films = film_angles(mesh);
      rows.push_back({ratio, segments, mesh.triangle_count(),
                      lostopos::mean_edge_length(mesh) / equilibrium.outer[0].radius, facets.rms_deviation_deg.value(),
                      facets.outer_mean_deg.value(), films.rms_deviation_deg.value(), films.outer_mean_deg.value()});
    }
  }
  return rows;
}

double film_order(const MeasuredExactly& coarse, const MeasuredExactly& fine) {
  return std::log(coarse.films_rms_deg / fine.films_rms_deg) / std::log(coarse.h_over_radius / fine.h_over_radius);
}

void write_angle_measures(const std::filesystem::path& file, const std::vector<MeasuredExactly>& rows) {
  base::AtomicFile out(file);
  out.stream() << "volume_ratio,segments,triangles,h_over_radius,facets_rms_deg,facets_outer_deg,films_rms_deg,"
                  "films_outer_deg\n";
  for (const MeasuredExactly& r : rows)
    out.stream() << base::to_text(r.volume_ratio) << ',' << r.segments << ',' << r.triangles << ','
                 << base::to_text(r.h_over_radius) << ',' << base::to_text(r.facets_rms_deg) << ','
                 << base::to_text(r.facets_outer_deg) << ',' << base::to_text(r.films_rms_deg) << ','
                 << base::to_text(r.films_outer_deg) << '\n';
  out.commit();
}

}  // namespace foamsim
