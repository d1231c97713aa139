#pragma once

#include "LosTopos/run/motion.h"

namespace lostopos::run {

inline constexpr const char* events_header = "step,time,kind,regions,x,y,z";

/// The table of topology changes, events.csv: step, time (T), kind (snap, edge_merge, separation, region_collapse,
/// burst), the regions that took part (separated by blanks; of a separation the two that lose contact first), and the
/// position x, y, z (L). One line for each event of the motion's last step.
Table events_table(const Motion& motion);

}  // namespace lostopos::run
