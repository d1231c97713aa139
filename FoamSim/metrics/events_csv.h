#pragma once

#include <string>

#include "FoamSim/metrics/metrics.h"

namespace foamsim {

/// The table of topology changes, events.csv: step, time (T), kind (snap, edge_merge, separation, region_collapse), the
/// regions that took part (separated by blanks; of a separation the two that lose contact first), and the position x,
/// y, z (L).
std::string events_header();
/// One line for each of the step's events, each with its newline.
std::string events_rows(const Metrics& metrics);

}  // namespace foamsim
