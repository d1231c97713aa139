#pragma once

#include <string>

#include "FoamSim/metrics/metrics.h"

namespace foamsim {

/// Names of the columns of metrics.csv, separated by commas.
std::string metrics_header();
/// One line with its newline; numbers with all digits, columns without a value are empty.
std::string metrics_row(const Metrics& metrics);

/// "step,region,volume" and one line a region.
std::string volumes_header();
std::string volumes_rows(const Metrics& metrics);

}  // namespace foamsim
