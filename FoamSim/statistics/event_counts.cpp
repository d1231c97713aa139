#include "FoamSim/statistics/event_counts.h"

#include <charconv>
#include <string>

#include "Base/error.h"
#include "Base/io/csv_table.h"
#include "LosTopos/run/events_csv.h"

namespace foamsim {
namespace {

long step_in(const std::string& cell) {
  long step = 0;
  const char* end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, step);
  if (error != std::errc() || stop != end || step < 0) throw base::InputError("'" + cell + "' is no step");
  return step;
}

}  // namespace

RunEvents::RunEvents(const std::filesystem::path& events_csv) {
  base::read_csv(events_csv, lostopos::run::events_header, [this](const std::vector<std::string>& cells) {
    EventCounts& counts = by_step_[step_in(cells[0])];
    if (cells[2] == "separation") ++counts.t1;
    if (cells[2] == "burst") ++counts.bursts;
    if (cells[2] == "region_collapse") ++counts.vanished;
  });
}

EventCounts RunEvents::between(long after, long until) const {
  EventCounts sum;
  for (auto at = by_step_.upper_bound(after); at != by_step_.end() && at->first <= until; ++at) {
    sum.t1 += at->second.t1;
    sum.bursts += at->second.bursts;
    sum.vanished += at->second.vanished;
  }
  return sum;
}

}  // namespace foamsim
