#include "FoamSim/studies/stability/stability_csv.h"

#include "Base/io/csv_cells.h"

namespace foamsim {

std::string stability_csv_header() {
  return "case,area,remeshing,verdict,steps,steps_asked,time,triangles,energy_rise,volume_drift,impulse_drift,"
         "figure_name,figure,seconds,reason";
}

std::string stability_csv_row(const StabilityRow& row) {
  base::CsvCells cells;
  cells.add(row.name).add(row.area).add(std::string(row.remeshing ? "on" : "off"));
  cells.add(std::string(row.verdict.passed ? "pass" : "fail")).add(row.steps).add(row.steps_asked).add(row.time);
  cells.add(static_cast<long>(row.triangles));
  cells.add(row.physics.energy_rise).add(row.physics.volume_drift).add(row.physics.impulse_drift);
  cells.add(row.verdict.figure_name).add(row.verdict.figure).add(row.seconds);
  return cells.add(row.verdict.reason).line();
}

}  // namespace foamsim
