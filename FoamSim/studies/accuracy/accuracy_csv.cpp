#include "FoamSim/studies/accuracy/accuracy_csv.h"

#include "Base/io/csv_cells.h"

namespace foamsim {

std::string accuracy_csv_header() {
  return "area,n,integrator,dt,ended,steps,time,triangles,resolution,area_error,radius_error,rim_error,wall_error,"
         "pressure_error,angle_rms_deg,angle_rms_film_deg,angle_outer_mean_deg,volume_drift,cpu_seconds,wall_seconds,"
         "seconds_effects,seconds_velocity,seconds_move,seconds_remesh,seconds_geometry,seconds_rest,reason";
}

std::string accuracy_csv_row(const AccuracyRow& row) {
  base::CsvCells cells;
  cells.add(row.area).add(row.n).add(row.integrator).add(row.dt).add(row.ended).add(row.steps).add(row.time);
  cells.add(static_cast<long>(row.triangles)).add(row.resolution);
  if (row.errors) {
    const EquilibriumErrors& e = *row.errors;
    cells.add(e.area).add(e.radius).add(e.rim).add(e.wall).add(e.pressure);
    cells.add(e.angle_rms_deg).add(e.angle_rms_film_deg).add(e.angle_outer_mean_deg);
  } else {
    for (int i = 0; i < 8; ++i) cells.add(std::optional<double>());
  }
  cells.add(row.volume_drift).add(row.cpu_seconds).add(row.wall_seconds);
  for (const char* stage : {"effects", "velocity", "move", "remesh", "geometry", "rest"})
    cells.add(row.stages.seconds(stage));
  return cells.add(row.reason).line();
}

}  // namespace foamsim
