#include "FoamSim/metrics/events_csv.h"

#include "Base/options/option_value.h"

namespace foamsim {

std::string events_header() {
  return "step,time,kind,regions,x,y,z";
}

std::string events_rows(const Metrics& metrics) {
  std::string rows;
  for (const lostopos::TopologyEvent& event : metrics.events) {
    rows += std::to_string(metrics.step) + "," + base::to_text(metrics.time) + "," + lostopos::name(event.kind) + ",";
    for (std::size_t i = 0; i < event.regions.size(); ++i)
      rows += (i == 0 ? "" : " ") + std::to_string(event.regions[i].index());
    for (double coordinate : event.position) rows += "," + base::to_text(coordinate);
    rows += "\n";
  }
  return rows;
}

}  // namespace foamsim
