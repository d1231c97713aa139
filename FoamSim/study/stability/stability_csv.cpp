#include "FoamSim/study/stability/stability_csv.h"

#include <algorithm>

#include "LosTopos/io/number_text.h"

namespace foamsim {
namespace {

std::string plain(std::string text) {
  std::ranges::replace(text, ',', ';');
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string number(double value) {
  std::string text;
  lostopos::append_number(text, value);
  return text;
}

}  // namespace

std::string stability_csv_header() {
  return "case,area,remeshing,verdict,steps,steps_asked,time,triangles,energy_rise,volume_drift,impulse_drift,"
         "figure_name,figure,seconds,reason";
}

std::string stability_csv_row(const StabilityRow& row) {
  std::string text = row.name + "," + row.area + "," + (row.remeshing ? "on" : "off") + "," +
                     (row.verdict.passed ? "pass" : "fail") + "," + std::to_string(row.steps) + "," +
                     std::to_string(row.steps_asked) + "," + number(row.time) + "," + std::to_string(row.triangles);
  for (double value : {row.physics.energy_rise, row.physics.volume_drift, row.physics.impulse_drift})
    text += "," + number(value);
  text += "," + row.verdict.figure_name + "," + (row.verdict.figure ? number(*row.verdict.figure) : "");
  return text + "," + number(row.seconds) + "," + plain(row.verdict.reason) + "\n";
}

}  // namespace foamsim
