#pragma once

#include <string>

#include "MultiTracker/run/metrics.h"

namespace multitracker {

/// Names of the columns of metrics.csv, separated by commas.
std::string metrics_header();
/// One line with its newline; numbers with all digits.
std::string metrics_row(const Metrics& metrics);

/// "step,time,region,volume,faces,touches_air", and one line for each region but the air.
std::string volumes_header();
std::string volumes_rows(const Metrics& metrics, const lostopos::SurfaceMesh& mesh);

}  // namespace multitracker
