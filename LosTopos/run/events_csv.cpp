#include "LosTopos/run/events_csv.h"

#include "Base/options/option_value.h"

namespace lostopos::run {
namespace {

std::string events_rows(const Motion& motion) {
  std::string rows;
  for (const TopologyEvent& event : motion.last().topology.events) {
    rows += std::to_string(motion.steps()) + "," + base::to_text(motion.time()) + "," + name(event.kind) + ",";
    for (std::size_t i = 0; i < event.regions.size(); ++i)
      rows += (i == 0 ? "" : " ") + std::to_string(event.regions[i].index());
    for (double coordinate : event.position) rows += "," + base::to_text(coordinate);
    rows += "\n";
  }
  return rows;
}

}  // namespace

Table events_table(const Motion& motion) {
  return {"events.csv", events_header, 1, [&motion] { return events_rows(motion); }};
}

}  // namespace lostopos::run
